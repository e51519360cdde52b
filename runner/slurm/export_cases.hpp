#pragma once
// A study for a cluster on which no daemon may run: its cases and a job script as files.
#include <filesystem>

#include "runner/study/study.hpp"

namespace capstan {

/// Names in an exported directory, besides `runs`.
inline constexpr const char* kExportedStudy = "study.json";

/// Writes DIR/study.json, DIR/runs/ID/case.json for each case, DIR/0.list, 1.list .. with the cases of each
/// task, and DIR/job.sh, a job array for sbatch. All paths in them are relative to DIR, so that it can be
/// copied to the cluster. Writing it again keeps what has been computed. Returns the number of tasks.
/// \param jobs     max number of tasks
/// \param program  capstan on the cluster
/// Throws std::filesystem::filesystem_error.
std::size_t export_cases(const Study& study, const std::filesystem::path& directory, std::size_t jobs,
                         const std::filesystem::path& program);

}  // namespace capstan
