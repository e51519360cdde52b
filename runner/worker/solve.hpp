#pragma once
// The process of one case: what `capstan solve` does. The only part of the runner that knows the physics.
#include <filesystem>

namespace capstan {

/// Runs the case of `case_file` in the directory `out`, from its newest checkpoint if there is one. Faults
/// and progress go to standard error. \param wall_seconds  after so many it is interrupted, with a checkpoint
/// \return the exit code of schema/exit_codes.md: 0 done, 2 invalid input,
/// 3 numerical failure, 75 interrupted with a
///         checkpoint written, 1 the environment failed (disk, permissions)
int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out, double wall_seconds);

}  // namespace capstan
