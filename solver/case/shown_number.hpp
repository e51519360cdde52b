#pragma once
// A number in a message.
#include <array>
#include <charconv>
#include <string>

namespace capstan {

/// The shortest decimals that read back to the same number.
inline std::string shown(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

}  // namespace capstan
