#pragma once
// Ids of studies and cases are compared in small letters (ASCII).
#include <algorithm>
#include <cctype>
#include <string>

namespace capstan {

inline std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace capstan
