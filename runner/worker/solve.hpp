#pragma once
// The process of one case.
#include <filesystem>

namespace capstan {

/// `capstan solve`: computes a case in the run directory `out`, from its newest checkpoint if there is one,
/// and writes its result. Issues, progress and errors go to standard error. \param wall_seconds  after these
/// the run is interrupted with a checkpoint \return kExitDone, kExitInvalidInput (the case, or a directory
/// that holds another case), kExitNoAnswer (a numerical
///   failure; the result says which), kExitInterrupted (a checkpoint is written), or kExitError (the disk,
///   permissions, a directory in which another process computes): schema/exit_codes.md
int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out, double wall_seconds);

}  // namespace capstan
