#pragma once
// Names of header fields, hosts and media types are compared without regard to case (ASCII).
#include <algorithm>
#include <cctype>
#include <string_view>

namespace capstan {

inline bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace capstan
