#pragma once
// The process of one case.
#include <filesystem>

namespace capstan {

/// `capstan solve`: computes a case in the run directory `out`, from its newest checkpoint if there is one,
/// and writes its result. Issues, progress and errors go to standard error.
/// \param wall_seconds  time limit: then the run writes a checkpoint and is interrupted
/// \return an exit code (schema/exit_codes.md): kExitDone, kExitInvalidInput (the case is invalid, or the
///         directory holds another case), kExitNoAnswer (a numerical failure; the result says which),
///         kExitInterrupted (a checkpoint is written), or kExitError (the disk, permissions, or another
///         process computes in the directory)
int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out, double wall_seconds);

}  // namespace capstan
