#include "runner/web/accept_header.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace capstan {
namespace {

/// All Accept headers as one list, in lower case and without white space.
std::string normalised_accept(const httplib::Request& request) {
  std::string list;
  const auto [first, last] = request.headers.equal_range("Accept");
  for (auto field = first; field != last; ++field) {
    if (!list.empty()) list += ',';
    for (const unsigned char c : field->second)
      if (!std::isspace(c)) list += static_cast<char>(std::tolower(c));
  }
  return list;
}

std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// How specifically a range such as "text/*" matches the type: 0 not at all, 3 exactly.
int specificity(std::string_view range, std::string_view type) {
  if (range == type) return 3;
  if (range == std::string(type.substr(0, type.find('/'))) + "/*") return 2;
  return range == "*/*" ? 1 : 0;
}

/// \param parameters  of a range, as "q=0.5;charset=utf-8"
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

/// The most specific range that matches decides.
double accepted_quality(const httplib::Request& request, std::string_view type) {
  const std::string accept = normalised_accept(request);
  if (accept.empty()) return 1;
  int best = 0;
  double quality = 0;
  for (std::string_view rest = accept; !rest.empty();) {
    std::string_view parameters = take_until(rest, ',');
    const int specific = specificity(take_until(parameters, ';'), type);
    if (specific <= best) continue;
    best = specific;
    quality = quality_of(parameters);
  }
  return quality;
}

bool wants_csv(const httplib::Request& request) {
  const std::string format = request.get_param_value("format");
  if (!format.empty()) return format == "csv";
  return accepted_quality(request, "text/csv") > accepted_quality(request, "application/json");
}

}  // namespace capstan
