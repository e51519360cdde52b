#include "runner/queries/typed_value.hpp"

#include <cmath>

namespace capstan {

using nlohmann::json;

bool means(const std::string& text, const json& value) {
  if (value.is_string()) return value.get_ref<const std::string&>() == text;
  if (value.is_structured()) return json::parse(text, nullptr, false) == value;
  const auto number = number_in<double>(text);
  return number && value.is_number() && std::abs(value.get<double>() - *number) <= 1e-9 * std::abs(*number);
}

std::optional<std::size_t> find_typed(const std::vector<json>& values, const std::string& text) {
  const auto number = number_in<double>(text);
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (number && values[i].is_number() && values[i].get<double>() == *number) return i;
    if (!found && means(text, values[i])) found = i;
  }
  return found;
}

}  // namespace capstan
