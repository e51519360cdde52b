#pragma once
// Run directories that belong to no case of the database. There are some after the database was replaced by a
// backup that is older than they are.
#include <vector>

#include "runner/store/database.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// Directories in `runs` whose name has the form of a case id but is not one of the database. Directories
/// with other names are not Capstan's.
std::vector<RunDirectory> orphaned_runs(const std::filesystem::path& runs, Database& database);

}  // namespace capstan
