#pragma once
// How much a run leaves on the disk, before it has run.
#include "solver/case/case.hpp"

namespace capstan {

/// Bytes of the run directory of a finished case and of its rows in the database, within some tens of
/// percent: its shapes, its history and the one checkpoint that is kept.
double run_size(const Case& c);

/// Those of its shapes alone.
double shapes_size(const Case& c);

}  // namespace capstan
