#pragma once
// The columns of a study's results. A column is named by its path in the JSON of a point, without
// "parameters.": "id", "Ca", "fidelity.nodes", "asked.fluid", "trust.warnings" (schema/results.md).
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
  double unit = 1;  ///< numbers are shown in it
};

/// What the values of all points are like, gathered page by page.
class ResultColumns {
 public:
  /// \param cases  as find_cases gives them
  void look_at(const nlohmann::ordered_json& cases);

  /// Every column: the known ones in their fixed order, with or without values, then what else was seen, by
  /// name.
  std::vector<ResultColumn> all() const;

  /// What was asked for on the axes, what varies, and what came of it.
  /// \param study  as find_study gives it
  std::vector<ResultColumn> summary(const nlohmann::ordered_json& study) const;

 private:
  struct Seen {
    nlohmann::ordered_json first;
    std::size_t count = 0;
    bool differs = false;
  };
  bool varies(const std::string& path) const;
  bool stands_in_summary(const std::string& path) const;
  bool has_words(const std::string& path) const;

  std::map<std::string, Seen> seen_;
  std::set<std::string> resolved_otherwise_;  ///< parameters whose value is another one than was asked for
  std::size_t points_ = 0;
};

/// One row a point.
Table table_of(const nlohmann::ordered_json& cases, const std::vector<ResultColumn>& columns);

/// The columns that always stand in a CSV file.
const std::vector<std::string>& known_columns();

}  // namespace capstan
