#pragma once
// A valid case from the text of its file.
#include <stdexcept>
#include <string_view>

#include "solver/case/parse.hpp"

namespace capstan::testing {

/// Throws with the first fault, if there is one.
inline Case parsed_case(std::string_view text) {
  const ParsedCase parsed = parse_case(nlohmann::json::parse(text));
  if (!parsed.value)
    throw std::invalid_argument(parsed.issues.front().pointer + ": " + parsed.issues.front().message);
  return *parsed.value;
}

}  // namespace capstan::testing
