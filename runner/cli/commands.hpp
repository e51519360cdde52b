#pragma once
// One function a subcommand: it declares the arguments and returns what to do once they are read.
#include <CLI/CLI.hpp>
#include <functional>

#include "runner/cli/program.hpp"

namespace capstan {

using Action = std::function<int()>;  ///< the exit code

Action declare_solve(CLI::App& command, const SolveCase& solve);
Action declare_serve(CLI::App& command);
Action declare_validate(CLI::App& command);
Action declare_submit(CLI::App& command);
Action declare_studies(CLI::App& command);
Action declare_show(CLI::App& command);
Action declare_watch(CLI::App& command);
Action declare_results(CLI::App& command);
Action declare_phase_diagram(CLI::App& command);
Action declare_cancel(CLI::App& command);

}  // namespace capstan
