#pragma once
// The points that follow from what is recorded of a study: those of a search for a boundary, or of a grid
// that is refined.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// The next points, each as an object with the values of the parameters that vary: {"Ca": 0.21, "V": 4}. None
/// if the study is complete, or neither seeks a boundary nor refines its grid.
/// \param document  of the study
std::vector<nlohmann::json> next_points(Database& database, const std::string& study_id,
                                        const nlohmann::json& document);

}  // namespace capstan
