#pragma once
#include <span>
#include <string>
#include <string_view>

namespace capstan {

/// "a, b, c"
inline std::string listed(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view each : words) list += (list.empty() ? "" : ", ") + std::string(each);
  return list;
}

}  // namespace capstan
