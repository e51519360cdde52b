#pragma once
// Values that a person types in a filter or a command: 0.25, skalak, {"dx": 0.2}.
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capstan {

/// The text as a number; nothing if it is no number, or if other characters follow the number.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Whether the text stands for the value. Numbers agree if they differ by less than 1e-9 of their size: a
/// typed 0.333333333 stands for 1/3.
bool means(const std::string& text, const nlohmann::json& value);

/// Index of the value that the text stands for: the exactly equal number, else the first that agrees.
std::optional<std::size_t> find_typed(const std::vector<nlohmann::json>& values, const std::string& text);

}  // namespace capstan
