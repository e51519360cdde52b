#pragma once
// The columns of a study's results (schema/results.md). The path of a column is that of its value in the JSON
// of a point, without "parameters.": "id", "Ca", "fidelity.nodes", "asked.fluid", "trust.warnings".
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "runner/render/table.hpp"

namespace capstan {

struct ResultColumn {
  std::string name;  ///< in the header
  std::string path;
  double unit = 1;  ///< numbers are divided by this unit
};

/// Collects which columns the points of a study have and which of them vary, page by page.
class ResultColumns {
 public:
  /// Adds points. \param cases  as find_cases returns them
  void look_at(const nlohmann::ordered_json& cases);

  /// All columns: the known ones in their fixed order, even if they are empty, then others in alphabetical
  /// order.
  std::vector<ResultColumn> all() const;

  /// The columns of the table for people: the requested values of the axes, the other parameters that vary,
  /// the main results. \param study  as find_study returns it
  std::vector<ResultColumn> summary(const nlohmann::ordered_json& study) const;

 private:
  /// The values of a column in the points so far.
  struct Seen {
    nlohmann::ordered_json first;
    std::size_t count = 0;
    bool differs = false;
  };
  bool varies(const std::string& path) const;
  bool stands_in_summary(const std::string& path) const;
  bool has_words(const std::string& path) const;

  std::map<std::string, Seen> seen_;
  std::set<std::string> resolved_otherwise_;  ///< parameters with another value than the requested one
  std::size_t points_ = 0;
};

/// A table with one row for each point.
Table table_of(const nlohmann::ordered_json& cases, const std::vector<ResultColumn>& columns);

/// Paths of the columns that every CSV file has, in their order.
const std::vector<std::string>& known_columns();

}  // namespace capstan
