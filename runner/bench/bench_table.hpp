#pragma once
// Figures as they are measured: rows of named values, for people or for programs.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "runner/results/table.hpp"

namespace capstan {

/// Prints rows (JSON objects with the same keys) as an aligned table under a title, or as JSON.
inline void print_rows(const std::string& title, const nlohmann::ordered_json& rows, bool json) {
  if (json) {
    std::cout << nlohmann::ordered_json{{"title", title}, {"rows", rows}}.dump(2) << '\n';
    return;
  }
  Table table;
  for (const auto& [key, value] : rows.front().items()) table.columns.push_back(key);
  for (const auto& row : rows) {
    std::vector<nlohmann::ordered_json> values;
    for (const auto& [key, value] : row.items()) values.push_back(value);
    table.rows.push_back(std::move(values));
  }
  std::cout << '\n' << title << "\n\n" << as_text(table) << std::flush;
}

}  // namespace capstan
