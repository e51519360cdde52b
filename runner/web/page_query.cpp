#include "runner/web/page_query.hpp"

#include <charconv>

namespace capstan {
namespace {

std::optional<std::int64_t> whole_number(const std::string& text) {
  std::int64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

}  // namespace

PageQuery read_page_query(const std::vector<std::pair<std::string, std::string>>& query) {
  PageQuery page;
  for (const auto& [key, value] : query) {
    if (key != "limit" && key != "after") {
      page.rest.emplace_back(key, value);
      continue;
    }
    const auto number = whole_number(value);
    if (key == "after" && number)
      page.wanted.after = number;
    else if (key == "limit" && number && *number >= 1 && *number <= PageRequest::kMost)
      page.wanted.limit = static_cast<int>(*number);
    else
      page.issues.push_back({key, key == "after" ? "must be the \"next\" of another page"
                                                 : "must be a whole number from 1 to 1000"});
  }
  return page;
}

nlohmann::ordered_json with_next(nlohmann::ordered_json answer, const Page& page) {
  answer["next"] = page.next ? nlohmann::ordered_json(std::to_string(*page.next)) : nlohmann::ordered_json();
  return answer;
}

}  // namespace capstan
