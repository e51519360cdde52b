#pragma once
// The words of result.json that its readers decide by: `stop` and `motion` (schema/run_directory.md).
#include "solver/observe/motion.hpp"
#include "solver/run_directory/stop.hpp"
