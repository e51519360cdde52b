#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// The parts of "a,b,c".
inline std::vector<std::string> comma_separated(std::string_view text) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

}  // namespace capstan
