#pragma once
// The enumerations of result.json on which its readers depend: `stop` and `motion` (schema/run_directory.md).
#include "solver/observe/motion.hpp"
#include "solver/run_directory/stop.hpp"
