#pragma once
// Numbers in messages.
#include <array>
#include <charconv>
#include <sstream>
#include <string>

namespace capstan {

/// The shortest decimal form that reads back to the same number.
inline std::string shown(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// The number rounded to some significant digits.
inline std::string rounded(double number, int digits = 3) {
  std::ostringstream text;
  text.precision(digits);
  text << number;
  return text.str();
}

}  // namespace capstan
