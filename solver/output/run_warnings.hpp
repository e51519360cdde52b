#pragma once
// The warnings of result.json: reasons to doubt the result of a run, and what the user can change.
#include <string>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

/// One sentence each. The warnings about the case itself (case_warnings) come first.
std::vector<std::string> run_warnings(const Case& c, const RunStatistics& statistics,
                                      const SurfaceWatch& surface);

}  // namespace capstan
