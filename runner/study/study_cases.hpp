#pragma once
// Expands a study into its cases.
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runner/study/dropped_keys.hpp"
#include "runner/study/expand.hpp"
#include "runner/study/issue_collector.hpp"
#include "runner/study/study.hpp"
#include "runner/study/study_notes.hpp"

namespace capstan {

class StudyCases {
 public:
  /// \param invalid_axes  parameters that the cases lack because their axis has issues
  StudyCases(const nlohmann::json& base, std::set<std::string> invalid_axes, IssueCollector& issues)
      : base_(base), invalid_axes_(std::move(invalid_axes)), issues_(issues) {}

  /// Sets cases, points and notes of a study that has its axes.
  ///
  /// A key of the base that has an issue is removed for all later points. A large axis value that has an
  /// issue is left out at all later points that have it. So the time grows with the size of the document plus
  /// the number of cases, not with their product. A small value with an issue stays, because without it the
  /// keys that depend on it would have issues, too.
  void expand(Study& study);

 private:
  std::optional<Case> read_case(const std::vector<Axis>& axes, const AxisIndices& indices);
  ParsedCase read_with_effect(nlohmann::json& flat, const std::vector<Axis>& axes,
                              const AxisIndices& indices);
  void add_issue(const Issue& issue, const std::vector<Axis>& axes, const AxisIndices& indices);

  nlohmann::json base_;  ///< without the keys that have issues
  std::set<std::string> invalid_axes_;
  IssueCollector& issues_;
  std::set<DroppedKeys::AxisValue> invalid_values_;
  DroppedKeys dropped_;
  CountedSentences choices_;   ///< what the solver chose
  CountedSentences warnings_;  ///< of settings that make the answer doubtful
};

}  // namespace capstan
