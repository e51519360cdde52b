#pragma once
// The base of a study's cases: what its document says, and when runs end if it does not say so.
#include <nlohmann/json.hpp>

namespace capstan {

/// Whether the runs of a study end as soon as their label is certain, because it asks for labels and its base
/// does not say when they end: it seeks a boundary, or has at least two axes of several numbers, so that it
/// is a phase diagram.
bool ends_runs_early(const nlohmann::json& document);

/// \param document  a study whose base is an object
nlohmann::json base_of(const nlohmann::json& document);

}  // namespace capstan
