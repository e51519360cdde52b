#pragma once
// Values as people type them in a filter or a command: 0.25, skalak, {"dx": 0.2}.
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capstan {

/// The number that the whole text is.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Whether the text stands for the value. Numbers are equal when they agree to nine digits: nobody types
/// more.
bool means(const std::string& text, const nlohmann::json& value);

/// Which of the values the text stands for; if more than one agrees to nine digits, the one that is equal.
std::optional<std::size_t> find_typed(const std::vector<nlohmann::json>& values, const std::string& text);

}  // namespace capstan
