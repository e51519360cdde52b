#pragma once
// Whether the database holds together: its pages, its references, its sums.
#include <string>
#include <vector>

#include "runner/queue/database.hpp"

namespace capstan {

/// What SQLite finds wrong with pages, indices and references.
std::vector<std::string> damage_of(Database& database);

/// Studies whose kept sums, or whose line of waiting cases, are not what a count gives.
std::vector<std::string> miscounted_studies(Database& database);

}  // namespace capstan
