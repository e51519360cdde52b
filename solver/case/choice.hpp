#pragma once
// What the solver chose in the place of what a case file asked for, and why.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

struct Choice {
  std::string key;               ///< of the case file
  nlohmann::json asked, chosen;  ///< its values
  std::string reason;            ///< a sentence for the user
  bool operator==(const Choice&) const = default;
};
using Choices = std::vector<Choice>;

/// "fluid: auto became stokes: " and the reason.
std::string in_words(const Choice& choice);

/// [{"key": ..., "asked": ..., "chosen": ..., "reason": ...}]
nlohmann::ordered_json to_json(const Choices& choices);

}  // namespace capstan
