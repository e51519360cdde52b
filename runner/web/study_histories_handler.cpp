// The histories of a study on one time grid.
#include <algorithm>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/render/comma_separated.hpp"
#include "runner/render/result_tables.hpp"
#include "runner/study/shown_value.hpp"
#include "runner/web/accept_header.hpp"
#include "runner/web/handlers.hpp"
#include "runner/web/page_query.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMaxTimes = 10'000;     // of a grid
constexpr std::size_t kPageNumbers = 50'000;  // about 1 MB of JSON
constexpr std::size_t kCsvNumbers = 500'000;  // CSV has no pages

struct AskedHistories {
  TimeGrid grid;
  std::vector<std::string> columns;
  CaseFilter filter;

  std::size_t numbers_of_a_point() const { return grid.size * columns.size(); }
  /// At least one.
  int points_of_a_page() const {
    return static_cast<int>(std::max<std::size_t>(1, kPageNumbers / numbers_of_a_point()));
  }
};

/// \param filter  all parameters of the query but those of a page
AskedHistories asked_histories(Database& database, const std::string& id, const httplib::Request& request,
                               CaseFilter filter) {
  std::erase_if(filter, [](const auto& each) { return each.first == "every" || each.first == "columns"; });
  const std::string columns = request.get_param_value("columns");
  return {time_grid(database, id, number_in<double>(request.get_param_value("every"))),
          columns.empty() ? columns_on_grid() : comma_separated(columns), std::move(filter)};
}

Response too_long(const std::string& detail) {
  return problem(400, "Invalid grid", "the answer would be too long", {{"every", detail}});
}

Response histories_as_json(Database& database, const std::string& id, const AskedHistories& asked,
                           const PageQuery& page) {
  PageRequest wanted = page.wanted;
  wanted.limit = std::min(wanted.limit, asked.points_of_a_page());
  const Page found = find_histories(database, id, asked.grid, asked.columns, asked.filter, wanted);
  ordered_json times = ordered_json::array();
  for (std::size_t i = 0; i < asked.grid.size; ++i) times.push_back(asked.grid.time(i));
  return json_response(200, with_next({{"study", id}, {"kt", times}, {"points", found.items}}, found, page));
}

/// All points that the filter selects.
Response histories_as_csv(Database& database, const ordered_json& study, const AskedHistories& asked) {
  std::string text = as_csv(histories_table(study, asked.grid, asked.columns, ordered_json::array()));
  PageRequest wanted{asked.points_of_a_page(), std::nullopt};
  std::size_t numbers = 0;
  for (bool is_last = false; !is_last;) {
    const Page part = find_histories(database, study["id"], asked.grid, asked.columns, asked.filter, wanted);
    numbers += part.items.size() * asked.numbers_of_a_point();
    if (numbers > kCsvNumbers)
      return too_long("raise it, or ask for fewer columns or points: CSV has at most " +
                      std::to_string(kCsvNumbers) + " numbers; JSON has pages");
    text += csv_rows(histories_table(study, asked.grid, asked.columns, part.items));
    wanted.after = part.next;
    is_last = !part.next;
  }
  return csv_response(std::move(text));
}

}  // namespace

Response get_study_histories(Service& service, const httplib::Request& request, const std::string& id) {
  const PageQuery page = read_page_query(request);
  if (!page.issues.empty()) return problem(400, "Invalid page", "the query names no page", page.issues);
  const Readers::Reader database = service.reader();
  const auto study = find_study(*database, id);
  if (!study) return problem(404, "Not found", "there is no study \"" + id + "\"");
  const AskedHistories asked = asked_histories(*database, id, request, page.rest);
  if (asked.grid.size > kMaxTimes)
    return too_long("raise it from " + shown_value(asked.grid.every) + ": a grid has at most " +
                    std::to_string(kMaxTimes) + " times");
  Response response = wants_csv(request) ? histories_as_csv(*database, *study, asked)
                                         : histories_as_json(*database, id, asked, page);
  response.headers["Vary"] = "Accept";
  return response;
}

}  // namespace capstan
