#pragma once
// Checks of the database: its pages, its references, its sums.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// Damage that SQLite finds in pages, indices and references; each as a sentence for users.
std::vector<std::string> damage_of(Database& database);

/// Throws DatabaseDamaged if pages of the file are damaged. Called at each start of the daemon, so it takes
/// seconds at most: the larger the file, the less is checked. damage_of checks everything.
void refuse_damaged_database(const std::filesystem::path& file);

/// Ids of the studies whose stored sums, or whose number of waiting cases, differ from a count.
std::vector<std::string> miscounted_studies(Database& database);

}  // namespace capstan
