#include "runner/web/accept.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace capstan {
namespace {

/// In small letters and without spaces: no value that is read here has any.
std::string normalised(std::string_view text) {
  std::string normal;
  for (const unsigned char c : text)
    if (!std::isspace(c)) normal += static_cast<char>(std::tolower(c));
  return normal;
}

std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// How closely a range such as "text/*" names the type: 0 not at all, 3 exactly.
int closeness(std::string_view range, std::string_view type) {
  if (range == type) return 3;
  if (range == std::string(type.substr(0, type.find('/'))) + "/*") return 2;
  return range == "*/*" ? 1 : 0;
}

/// Of the parameters of a range, "q=0.5;charset=utf-8".
double quality_of(std::string_view parameters) {
  double quality = 1;
  while (!parameters.empty()) {
    const std::string_view parameter = take_until(parameters, ';');
    if (parameter.starts_with("q="))
      std::from_chars(parameter.data() + 2, parameter.data() + parameter.size(), quality);
  }
  return std::clamp(quality, 0.0, 1.0);
}

}  // namespace

double accepted_quality(std::string_view accept, std::string_view type) {
  const std::string normal = normalised(accept);
  if (normal.empty()) return 1;
  int closest = 0;
  double quality = 0;
  for (std::string_view rest = normal; !rest.empty();) {
    std::string_view parameters = take_until(rest, ',');
    const int close = closeness(take_until(parameters, ';'), type);
    if (close <= closest) continue;
    closest = close;
    quality = quality_of(parameters);
  }
  return quality;
}

}  // namespace capstan
