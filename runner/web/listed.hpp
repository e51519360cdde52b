#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// "a, b, c"
inline std::string listed(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view each : words) list += (list.empty() ? "" : ", ") + std::string(each);
  return list;
}

/// The words of "a,b,c".
inline std::vector<std::string> words_of_list(std::string_view list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

}  // namespace capstan
