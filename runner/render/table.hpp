#pragma once
// Rows of values as text: aligned columns for people, CSV for programs.
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace capstan {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::ordered_json>> rows;
  std::set<std::size_t> exact = {};  ///< columns whose numbers are shown in full also to people
};

std::string aligned_right(const std::string& text, std::size_t width);
std::string without_trailing_spaces(std::string line);

/// Numbers aligned right and, unless their column is exact, rounded to four digits; words left.
std::string as_text(const Table& table);

/// RFC 4180, with a header; numbers in full.
std::string as_csv(const Table& table);
/// The same without the header.
std::string csv_rows(const Table& table);

}  // namespace capstan
