#include "runner/cli/axis_text.hpp"

#include "runner/render/table.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {

std::string axis_text(const std::string& parameter, const std::vector<nlohmann::ordered_json>& values) {
  constexpr std::size_t kMaxShown = 8;
  const std::size_t first = values.size() > kMaxShown ? kMaxShown - 2 : values.size();
  std::string text = parameter + ":";
  for (std::size_t i = 0; i < first; ++i) text += " " + shown_value(values[i]);
  if (first < values.size())
    text += " ... " + shown_value(values.back()) + " (" + std::to_string(values.size()) + " values)";
  return text;
}

}  // namespace capstan
