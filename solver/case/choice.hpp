#pragma once
// Settings that the solver chose instead of those of the case file, and why.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

struct Choice {
  std::string key;               ///< key of the case file
  nlohmann::json asked, chosen;  ///< values of the key
  std::string reason;            ///< a sentence for the user
  bool operator==(const Choice&) const = default;
};
using Choices = std::vector<Choice>;

/// "fluid: auto became stokes: <reason>"
std::string in_words(const Choice& choice);

/// [{"key": ..., "asked": ..., "chosen": ..., "reason": ...}]
nlohmann::ordered_json to_json(const Choices& choices);

}  // namespace capstan
