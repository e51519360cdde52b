#pragma once
// The part "refine" of a study: its grid is made finer where the motion changes.
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/axis.hpp"
#include "runner/study/issue_collector.hpp"

namespace capstan {

struct StudyRefinement {
  std::array<std::string, 2> axes;  ///< the parameters of the cells, in the order of axis_parameters()
  std::array<double, 2> sides{};    ///< a cell whose sides are at most these is not divided
};

/// Reads the value of /refine.
/// \param axes  of the study, in the order of axis_parameters()
std::optional<StudyRefinement> read_refinement(const nlohmann::json& given, const std::vector<Axis>& axes,
                                               IssueCollector& issues);

/// The refinement of a study that was valid when it was stored; nothing if it has none.
std::optional<StudyRefinement> refinement_of(const nlohmann::json& document);

}  // namespace capstan
