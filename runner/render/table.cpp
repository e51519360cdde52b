#include "runner/render/table.hpp"

#include <algorithm>

#include "runner/render/printable.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Columns that a text in UTF-8 takes on a terminal, at one column a character.
std::size_t width_of(const std::string& text) {
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string spaces_up_to(std::size_t width, const std::string& text) {
  return std::string(width - std::min(width, width_of(text)), ' ');
}

std::string short_text(const ordered_json& value, bool is_exact) {
  if (value.is_number_float() && !is_exact) return rounded(value.get<double>(), 4);
  const std::string text = printable(shown_value(value));
  return text.substr(0, text.find('\n'));  // only the first line of a message
}

std::string quoted(const std::string& text) {
  if (text.find_first_of("\",\n\r") == std::string::npos) return text;
  std::string inside;
  for (char c : text) inside += c == '"' ? std::string("\"\"") : std::string(1, c);
  return '"' + inside + '"';
}

std::string aligned_left(const std::string& text, std::size_t width) {
  return text + spaces_up_to(width, text);
}

std::string cell_text(const Table& table, std::size_t row, std::size_t column) {
  return short_text(table.rows[row][column], table.exact.contains(column));
}

std::size_t width_of(const Table& table, std::size_t column) {
  std::size_t width = width_of(table.columns[column]);
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    width = std::max(width, width_of(cell_text(table, row, column)));
  return width;
}

bool is_numeric(const Table& table, std::size_t column) {
  const auto is_no_word = [&](const auto& row) { return !row[column].is_string(); };
  return std::all_of(table.rows.begin(), table.rows.end(), is_no_word);
}

}  // namespace

std::string aligned_right(const std::string& text, std::size_t width) {
  return spaces_up_to(width, text) + text;
}

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string as_text(const Table& table) {
  std::vector<std::string> lines(table.rows.size() + 1);
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::size_t width = width_of(table, column);
    const auto aligned = is_numeric(table, column) ? aligned_right : aligned_left;
    lines[0] += aligned(table.columns[column], width) + "  ";
    for (std::size_t row = 0; row < table.rows.size(); ++row)
      lines[row + 1] += aligned(cell_text(table, row, column), width) + "  ";
  }
  std::string text;
  for (const std::string& line : lines) text += without_trailing_spaces(line) + "\n";
  return text;
}

std::string as_csv(const Table& table) {
  std::string header;
  for (const std::string& name : table.columns) header += (header.empty() ? "" : ",") + quoted(name);
  return header + "\r\n" + csv_rows(table);
}

std::string csv_rows(const Table& table) {
  std::string text;
  for (const auto& row : table.rows) {
    for (std::size_t column = 0; column < row.size(); ++column)
      text += (column > 0 ? "," : "") + quoted(shown_value(row[column]));
    text += "\r\n";
  }
  return text;
}

}  // namespace capstan
