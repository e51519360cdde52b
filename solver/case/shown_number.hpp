#pragma once
// A number in a message.
#include <array>
#include <charconv>
#include <sstream>
#include <string>

namespace capstan {

/// The shortest decimals that read back to the same number.
inline std::string shown(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// To that many significant digits.
inline std::string rounded(double number, int digits = 3) {
  std::ostringstream text;
  text.precision(digits);
  text << number;
  return text.str();
}

}  // namespace capstan
