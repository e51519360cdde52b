#pragma once
// Another case in the place of a case: the study stays whole, and remembers what stood there.
#include <nlohmann/json.hpp>
#include <string>

#include "runner/store/database.hpp"
#include "solver/case/case.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// Queues the case unless it is known: its id.
std::string add_case(Database& database, const Case& c);

/// Puts cases of that fidelity in the place of the study's failed and diverged ones. If one of them would be
/// invalid nothing is changed; the faults of the first such case. A fidelity that no case could have is a
/// fault also where there is nothing to replace.
/// \param fidelity  as in a case file: a preset or an object of knobs
Issues replace_failed(Database& database, const std::string& study_id, const nlohmann::json& fidelity);

/// Gives the cases that an earlier program has stored their cost.
void price_cases(Database& database);

/// Puts cases of the present numerics version in the place of those that an earlier program has queued:
/// computed now, they would be recorded under an id that promises another result.
void replace_outdated(Database& database);

}  // namespace capstan
