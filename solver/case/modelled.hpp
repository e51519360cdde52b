#pragma once
// The models of a case in words.
#include <optional>
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Capsule, membrane, fluids, flow, walls and time, one phrase each. Of the numbers they hold those of shape,
/// law, grid and mesh, and not those that the words do not depend on: Ca, V, Re, E_b, time step and end.
std::vector<std::string> modelled(const Case& c);

/// The time step k dt; nothing where the stepper chooses it.
std::optional<double> equal_time_step(const Case& c);

}  // namespace capstan
