#pragma once
// Parses the JSON text of a valid case.
#include <stdexcept>
#include <string_view>

#include "solver/case/parse.hpp"

namespace capstan::testing {

/// Throws std::invalid_argument with the first issue if there is one.
inline Case parsed_case(std::string_view text) {
  const ParsedCase parsed = parse_case(nlohmann::json::parse(text));
  if (!parsed.value)
    throw std::invalid_argument(parsed.issues.front().pointer + ": " + parsed.issues.front().message);
  return *parsed.value;
}

}  // namespace capstan::testing
