#include "runner/web/page_query.hpp"

#include <array>
#include <charconv>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

constexpr std::size_t kListDigits = 8;

template <class Number>
std::optional<Number> number_of(std::string_view text, int base) {
  Number number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

std::string name_of_list(const std::string& path, const CaseFilter& filter) {
  std::string name = path;
  for (const auto& [key, value] : filter) name += '\n' + key + '=' + value;
  return sha256_hex(name).substr(0, kListDigits);
}

/// A cursor consists of the name of the list and a position in it.
std::string cursor(const std::string& list, std::int64_t position) {
  std::array<char, 20> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), position, 16).ptr;
  return list + std::string(digits.data(), end);
}

std::optional<std::int64_t> position(const std::string& list, const std::string& cursor) {
  if (!cursor.starts_with(list)) return std::nullopt;
  return number_of<std::int64_t>(std::string_view(cursor).substr(list.size()), 16);
}

void read_after(const std::string& value, PageQuery& page) {
  page.wanted.after = position(page.list, value);
  if (!page.wanted.after)
    page.issues.push_back({"after", "must be the \"next\" of a page of this very list"});
}

}  // namespace

PageQuery read_page_query(const httplib::Request& request) {
  PageQuery page;
  for (const auto& [key, value] : request.params)
    if (key != "limit" && key != "after" && key != "format") page.rest.emplace_back(key, value);
  page.list = name_of_list(request.path, page.rest);
  for (const auto& [key, value] : request.params) {
    if (key == "limit") page.wanted.limit = number_of<int>(value, 10).value_or(PageRequest::kMax);
    if (key == "after") read_after(value, page);
  }
  return page;
}

nlohmann::ordered_json with_next(nlohmann::ordered_json answer, const Page& page, const PageQuery& asked) {
  answer["next"] =
      page.next ? nlohmann::ordered_json(cursor(asked.list, *page.next)) : nlohmann::ordered_json();
  return answer;
}

}  // namespace capstan
