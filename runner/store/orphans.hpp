#pragma once
// Run directories that belong to no case: the database is older than they are.
#include <vector>

#include "runner/store/database.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// Directories whose name could be a case's id and is none. What has another name is not ours.
std::vector<RunDirectory> orphans_in(const std::filesystem::path& runs, Database& database);

}  // namespace capstan
