#pragma once
// Estimated disk space and memory of a run, from its case.
#include "solver/case/case.hpp"

namespace capstan {

/// Bytes of the run directory of a finished case and of its rows in the database, to some tens of percent:
/// shapes, history and last checkpoint of all its runs.
double run_size(const Case& c);

/// Bytes of its shapes.
double shapes_size(const Case& c);

/// Bytes of the process at its peak, to some tens of percent.
double run_memory(const Case& c);

}  // namespace capstan
