#pragma once
// Slurm's states and reasons in words.
#include "runner/slurm/listed_task.hpp"

namespace capstan {

/// Why a task waits, after "it waits in Slurm's queue: ".
std::string why_it_waits(const ListedTask& task);

/// How a task ended before its cases did, as a clause: "its node failed".
std::string how_it_ended(const ListedTask& task);

}  // namespace capstan
