#pragma once
// Warnings about a case that can be run, but whose settings make its result doubtful. They follow from the
// case alone, before the run.
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Whether the iteration for the flow is likely to diverge because the inner viscosity is low and the spacing
/// is small. Spheres (Ca = 0.1): at dx = 0.1 V = 0.03 and 0.01 fail at once, 0.05 does not; at dx = 0.2 0.01
/// does not.
bool is_too_thin_for_lattice(const Case& c);

/// Sentences: what is wrong, why, and what to do.
std::vector<std::string> case_warnings(const Case& c);

}  // namespace capstan
