#include "solver/case/choice.hpp"

namespace capstan {
namespace {

std::string text_of(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::string in_words(const Choice& choice) {
  return choice.key + ": " + text_of(choice.asked) + " became " + text_of(choice.chosen) + ": " +
         choice.reason;
}

nlohmann::ordered_json to_json(const Choices& choices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Choice& choice : choices)
    list.push_back(
        {{"key", choice.key}, {"asked", choice.asked}, {"chosen", choice.chosen}, {"reason", choice.reason}});
  return list;
}

}  // namespace capstan
