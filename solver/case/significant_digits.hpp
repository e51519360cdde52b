#pragma once
#include <array>
#include <charconv>

namespace capstan {

/// The number rounded to some significant decimal digits, 1 to 17.
inline double with_significant_digits(double number, int digits) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific, digits - 1).ptr;
  double result = number;
  std::from_chars(text.begin(), end, result);
  return result;
}

}  // namespace capstan
