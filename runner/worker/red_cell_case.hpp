#pragma once
#include "solver/case/case.hpp"

namespace capstan {

/// The paper's red blood cell (biconcave, Skalak's law with C = 5, E_b = 0.015, V = 4) in the quasisteady
/// model.
/// \param dx     lattice spacing
/// \param nodes  number of the membrane's nodes: 162, 642, 2562 or 10242
/// \param kdt    time step, in units of the inverse shear rate
/// \param kt     end of the run
Case red_cell_case(double Ca, double dx, int nodes, double kdt, double kt);

/// The same cell at fidelity `standard` (dx = 0.1, 2562 nodes); the program chooses the time steps.
Case standard_red_cell_case(double Ca, double kt);

}  // namespace capstan
