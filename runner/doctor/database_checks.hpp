#pragma once
// Whether the database holds together: its pages, its references, its sums.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// What SQLite finds wrong with pages, indices and references.
std::vector<std::string> damage_of(Database& database);

/// Throws DatabaseDamaged if pages of the file are not as SQLite has written them. To be asked at each start,
/// so it takes seconds at most: of a file of more than 4 GB the histories are left to `damage_of`, and to
/// those who read them.
void refuse_damaged_database(const std::filesystem::path& file);

/// Studies whose kept sums, or whose line of waiting cases, are not what a count gives.
std::vector<std::string> miscounted_studies(Database& database);

}  // namespace capstan
