#pragma once
// The program `capstan`: a table of subcommands.
#include <filesystem>
#include <functional>

namespace capstan {

/// Runs one case in its directory; the exit code of `capstan solve`.
using SolveCase =
    std::function<int(const std::filesystem::path& case_file, const std::filesystem::path& out)>;

/// \param solve  stands apart, since it alone needs the physics
int run_program(int argc, char** argv, const SolveCase& solve);

}  // namespace capstan
