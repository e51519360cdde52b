#pragma once
// Filters on the points of a study: state, motion and values of parameters.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace capstan {

/// Conditions that a point must all meet: {"motion", "tumbling"}, {"state", "done"}, or a parameter and its
/// value. For an axis the value asked for at the point is compared. For another parameter the value of the
/// case is compared, or the word in the study's base (fluid=auto).
using CaseFilter = std::vector<std::pair<std::string, std::string>>;

/// The word that the filter asks for under a key, or "".
std::string wanted_word(const CaseFilter& filter, const std::string& key);

/// The conditions of a filter on parameters; state and motion are left to the SQL query.
class ParameterFilter {
 public:
  /// \param axes  [{"parameter", "values"}] of the study
  ParameterFilter(const CaseFilter& filter, const nlohmann::json& axes);

  /// \param asked     JSON of the values asked for at the point
  /// \param document  JSON of its case
  bool matches(const std::string& asked, const std::string& document) const;

 private:
  struct Condition {
    std::string key, text;
    bool is_axis = false;
    std::optional<nlohmann::json> value;  ///< if this is an axis: its value that `text` stands for, if any
  };

  std::vector<Condition> conditions_;
};

}  // namespace capstan
