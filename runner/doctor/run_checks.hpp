#pragma once
// Whether the run directories hold what the database says.
#include <functional>
#include <string>

#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// A fault, and what would mend it; empty where nothing can.
using RunFault = std::function<void(const std::string& what, const std::function<void()>& mend)>;

/// Goes through all cases and all directories, and tells each fault.
/// \param runs  the directory of the run directories
void find_run_faults(const std::filesystem::path& runs, Database& database, const RunFault& tell);

}  // namespace capstan
