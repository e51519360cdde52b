#pragma once
// Cases that make the same time steps, and differ in the end of the run only: a longer run can go on from the
// last state of a shorter one.
#include <string>

#include "solver/case/case.hpp"

namespace capstan {

/// The content id without the end of the run, without the companion, and without extra checkpoints. Cases
/// with equal ids have the same state at the end of each step, to the last bit.
std::string steps_id(const Case& c);

/// Whether a run with the end `later` passes the last state of a run with the end `earlier` without stopping
/// before. A label may have ended a run early, so that its length must be known.
/// \param reached  kt of the last record of the earlier run
bool passes_end_of(const Until& earlier, double reached, const Until& later);

}  // namespace capstan
