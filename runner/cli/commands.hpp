#pragma once
// One function a subcommand: it declares the arguments and returns what to do once they are read.
#include <CLI/CLI.hpp>
#include <functional>

#include "runner/cli/program.hpp"

namespace capstan {

using Action = std::function<int()>;  ///< the exit code

Action declare_solve(CLI::App& command, const SolveCase& solve);
Action declare_validate(CLI::App& command);

}  // namespace capstan
