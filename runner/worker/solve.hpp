#pragma once
// The process of one case.
#include <filesystem>

namespace capstan {

/// `capstan solve`: computes a case in the run directory `out`, from its newest checkpoint if there is one,
/// and writes its result. Issues, progress and errors go to standard error.
/// \param wall_seconds  time limit: then the run writes a checkpoint and is interrupted
/// \param shorter  directory of a run with equal steps, from whose end this run goes on; empty: it starts at
///                 kt = 0
/// \return an exit code (schema/exit_codes.md): kExitDone, kExitInvalidInput (the case is invalid, the
///         directory holds another case, or the case cannot go on from the shorter run), kExitNoAnswer (a
///         numerical failure; the result says which), kExitInterrupted (a checkpoint is written), or
///         kExitError (the disk, permissions, or another process computes in the directory)
int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out, double wall_seconds,
               const std::filesystem::path& shorter = {});

}  // namespace capstan
