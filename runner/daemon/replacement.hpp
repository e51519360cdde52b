#pragma once
// Replacement of a study's cases by others: at another fidelity, or of the present numerics version. Each
// point keeps the id of the case that it had before.
#include <nlohmann/json.hpp>
#include <string>

#include "runner/store/database.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// Replaces the study's failed and diverged cases by cases of another fidelity. If one of these is invalid,
/// nothing is changed and its issues are returned; an impossible fidelity is an issue also if no case has
/// failed.
/// \param fidelity  as in a case file: a preset or an object of settings
Issues replace_failed(Database& database, const std::string& study_id, const nlohmann::json& fidelity);

/// Replaces queued cases of earlier numerics versions by those of the present one. The version is a part of a
/// case's id, and this solver computes results of the present version only.
void replace_outdated(Database& database);

}  // namespace capstan
