#include "runner/web/request_target.hpp"

#include <algorithm>
#include <charconv>

namespace capstan {
namespace {

template <class Use>
void for_each_part(std::string_view text, char separator, const Use& use) {
  for (;;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    use(text.substr(0, end));
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

std::string form_decoded(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), '+', ' ');
  return percent_decoded(spaced).value_or("");
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    unsigned char byte = 0;
    const char* const end = text.data() + std::min(i + 3, text.size());
    const auto read = std::from_chars(text.data() + i + 1, end, byte, 16);
    if (read.ec != std::errc() || read.ptr != text.data() + i + 3) return std::nullopt;
    decoded += static_cast<char>(byte);
    i += 2;
  }
  return decoded;
}

std::vector<std::string> path_segments(std::string_view path) {
  std::vector<std::string> segments;
  if (path.starts_with('/')) path.remove_prefix(1);
  for_each_part(path, '/',
                [&](std::string_view part) { segments.push_back(percent_decoded(part).value_or("")); });
  return segments;
}

httplib::Params parse_query(std::string_view text) {
  httplib::Params params;
  for_each_part(text, '&', [&](std::string_view part) {
    const std::size_t equals = std::min(part.find('='), part.size());
    if (!part.empty())
      params.emplace(form_decoded(part.substr(0, equals)),
                     form_decoded(part.substr(std::min(equals + 1, part.size()))));
  });
  return params;
}

}  // namespace capstan
