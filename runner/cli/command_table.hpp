#pragma once
// The table of commands, in the order in which `capstan --help` lists them.
#include <vector>

#include "runner/cli/command.hpp"
#include "runner/cli/program.hpp"

namespace capstan {

/// serve, doctor, backup, disk: they work on a data directory.
std::vector<Command> data_commands();

/// validate, plan, fidelity, submit … why: they read a study file, or ask a server.
std::vector<Command> study_commands();

/// solve, compare, estimate, tradeoff, bench: they compute in this process.
std::vector<Command> worker_commands(const WorkerCommands& worker);

}  // namespace capstan
