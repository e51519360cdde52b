#pragma once
// Starting a worker as a child process.
#include <sys/types.h>

#include <filesystem>
#include <string>

#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// Starts PROGRAM solve CASE.json --out DIR as schema/run_directory.md describes it. Returns its process id.
/// Throws std::system_error if that cannot be done.
/// \param token  of the attempt (attempt_token.hpp)
/// \param lock   descriptor of the directory's lock, which the daemon holds; the worker inherits it
pid_t spawn_worker(const std::filesystem::path& program, const RunDirectory& directory,
                   const std::string& token, int lock);

}  // namespace capstan
