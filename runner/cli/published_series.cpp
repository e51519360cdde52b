#include "runner/cli/published_series.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include "runner/render/comma_separated.hpp"
#include "runner/study/input_file.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {
namespace {

using Row = std::map<std::string, std::string>;

/// The lines below the header.
std::vector<Row> rows_of(const std::filesystem::path& file) {
  std::istringstream lines(read_input(file));
  std::vector<std::string> columns;
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with("#")) continue;
    const std::vector<std::string> cells = comma_separated(line);
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(columns.size(), cells.size()); ++i) row[columns[i]] = cells[i];
  }
  if (rows.empty())
    throw std::invalid_argument(input_name(file) + (columns.empty() ? " is empty" : " has only a header") +
                                ": there is no published point to draw");
  return rows;
}

double number_in(const Row& row, const std::string& column) {
  double number = std::numeric_limits<double>::quiet_NaN();
  const auto found = row.find(column);
  if (found != row.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), number);
  return number;
}

bool is_parameter(const std::string& column) {
  return column != "paper" && column != "kt" && column != "D_xy" && column != "theta";
}

bool fits(const Row& row, const PicturedCase& c) {
  return std::ranges::all_of(row, [&](const auto& cell) {
    const auto& [column, value] = cell;
    return !is_parameter(column) || value.empty() ||
           value == shown_value(c.parameters.value(column, nlohmann::ordered_json()));
  });
}

std::string name_of(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// The paper of a row; without such a column the name of the file.
std::string source_of(const Row& row, const std::filesystem::path& file) {
  const auto paper = row.find("paper");
  return paper == row.end() ? name_of(file) : paper->second;
}

template <class Series>
Series& series_named(const std::string& title, std::vector<Series>& all) {
  const auto found = std::ranges::find(all, title, &Series::title);
  return found != all.end() ? *found : all.emplace_back(Series{title, {}});
}

}  // namespace

std::vector<PublishedSeries> published_series(const std::filesystem::path& file,
                                              const std::vector<PicturedCase>& cases) {
  std::vector<PublishedSeries> all;
  for (const Row& row : rows_of(file)) {
    if (!row.contains("kt") || !row.contains("D_xy"))
      throw std::invalid_argument(input_name(file) + " needs the columns kt and D_xy");
    const PublishedPoint point{number_in(row, "kt"), number_in(row, "D_xy"), number_in(row, "theta")};
    if (!std::isfinite(point.kt) || std::ranges::none_of(cases, [&](const auto& c) { return fits(row, c); }))
      continue;
    series_named(source_of(row, file), all).points.push_back(point);
  }
  return all;
}

std::vector<PublishedBoundary> published_boundaries(const std::filesystem::path& file, const std::string& x,
                                                    const std::string& y) {
  std::vector<PublishedBoundary> all;
  for (const Row& row : rows_of(file)) {
    if (!row.contains(x) || !row.contains(y))
      throw std::invalid_argument(input_name(file) + " needs the columns " + x + " and " + y);
    const double at_x = number_in(row, x), at_y = number_in(row, y);
    if (std::isfinite(at_x) && std::isfinite(at_y))
      series_named(source_of(row, file), all).points.push_back({at_x, at_y});
  }
  return all;
}

}  // namespace capstan
