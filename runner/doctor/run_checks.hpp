#pragma once
// Checks that the run directories and the database agree.
#include <filesystem>
#include <functional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Called for each finding. `repair` repairs it when it is called; it is empty where nothing can be done.
using ReportFinding = std::function<void(const std::string& what, const std::function<void()>& repair)>;

/// Checks the results, histories and files of all cases, and looks for run directories without a case.
/// \param runs  the directory of the run directories
void check_runs(const std::filesystem::path& runs, Database& database, const ReportFinding& report);

}  // namespace capstan
