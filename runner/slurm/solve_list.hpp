#pragma once
// What a task of a job array does: it computes the cases of a list one after another, each in a process of
// its own.
#include <filesystem>

namespace capstan {

/// Notes the beginning and the end of each case in `journal`. Cases that have a result, and those whose
/// attempt was withdrawn, are passed over. SIGUSR1, SIGTERM and SIGINT ask the present case for a checkpoint;
/// no further case is begun. Returns the exit code: done, or interrupted after such a signal.
int solve_list(const std::filesystem::path& list, const std::filesystem::path& journal);

}  // namespace capstan
