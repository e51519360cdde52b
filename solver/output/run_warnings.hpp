#pragma once
// What makes the answer of a run doubtful: what was seen, why it matters, and what to do.
#include <string>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

/// Those of the case's settings (case_warnings) first.
std::vector<std::string> run_warnings(const Case& c, const RunStatistics& statistics,
                                      const SurfaceWatch& surface);

}  // namespace capstan
