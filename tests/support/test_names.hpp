#pragma once
// Names of value-parameterised tests, which may hold letters, digits and _ only.
#include <algorithm>
#include <sstream>
#include <string>

namespace capstan::testing {

/// A number or text as a part of a test's name: "0_25" for 0.25.
template <class Value>
std::string name_part(const Value& value) {
  std::ostringstream text;
  text << value;
  std::string name = text.str();
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

/// Generator of INSTANTIATE_TEST_SUITE_P for numbers: "V_0_25" for the prefix "V" and the parameter 0.25.
inline auto number_names(const std::string& prefix) {
  return [prefix](const auto& test) { return prefix + "_" + name_part(test.param); };
}

}  // namespace capstan::testing
