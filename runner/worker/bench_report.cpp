#include "runner/worker/bench_report.hpp"

#include <ostream>
#include <utility>

#include "runner/render/table.hpp"

namespace capstan {

void BenchReport::add(const std::string& title, const nlohmann::ordered_json& rows,
                      std::set<std::size_t> exact) {
  if (json_) {
    tables_.push_back({{"title", title}, {"rows", rows}});
    return;
  }
  Table table{{}, {}, std::move(exact)};
  for (const auto& [key, value] : rows.front().items()) table.columns.push_back(key);
  for (const auto& row : rows) {
    std::vector<nlohmann::ordered_json> values;
    for (const auto& [key, value] : row.items()) values.push_back(value);
    table.rows.push_back(std::move(values));
  }
  out_ << '\n' << title << "\n\n" << as_text(table) << std::flush;
}

void BenchReport::finish() {
  if (json_) out_ << nlohmann::ordered_json{{"tables", tables_}}.dump(2) << '\n';
}

}  // namespace capstan
