#pragma once
// Ids of studies and cases are written in small letters (ASCII), whatever is typed.
#include <algorithm>
#include <cctype>
#include <string>

namespace capstan {

inline std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace capstan
