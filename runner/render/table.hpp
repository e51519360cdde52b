#pragma once
// Tables as text with aligned columns, for people, and as CSV, for programs.
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace capstan {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::ordered_json>> rows;
  std::set<std::size_t> exact = {};  ///< indices of columns whose numbers as_text() does not round
};

/// Pads with spaces on the left to `width` characters.
std::string aligned_right(const std::string& text, std::size_t width);
std::string without_trailing_spaces(std::string line);

/// A header and one line a row. Numbers are aligned right and rounded to four digits, except in exact
/// columns; words are aligned left. Of texts with several lines only the first is shown.
std::string as_text(const Table& table);

/// RFC 4180, with a header. Numbers have all their digits.
std::string as_csv(const Table& table);
/// The rows of as_csv() without the header.
std::string csv_rows(const Table& table);

}  // namespace capstan
