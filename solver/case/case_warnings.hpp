#pragma once
// Warnings about a case that can be run, but whose settings make its result doubtful. They follow from the
// case alone, before the run.
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Whether the solution of the flow is likely to become unstable because the inner viscosity is low compared
/// with inertia. A sphere of V = 0.025, Ca = 1, dx = 0.2: it fails at Re/V = 16 and more, not at 8. Without
/// inertia V = 0.01 is stable at dx = 0.1.
bool is_too_thin_for_lattice(const Case& c);

/// Sentences: what is wrong, why, and what to do.
std::vector<std::string> case_warnings(const Case& c);

}  // namespace capstan
