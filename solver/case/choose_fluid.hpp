#pragma once
// The flow model of a case that leaves the choice to the solver ("fluid": "auto", the default).
//
// Boundary integrals are the more accurate model at equal cost: beside them the lattice errs 7 to 100 times
// more. They know no inertia, no walls and no grid, so a case that asks for one of these gets a lattice.
#include <nlohmann/json.hpp>
#include <string>

#include "solver/case/case.hpp"

namespace capstan {

/// Up to here inertia is small enough to be left out: Re = 0.05 changes the deformation of a sphere by 0.5 %.
inline constexpr double kMaxStokesRe = 0.1;

struct FluidChoice {
  Fluid fluid;
  std::string reason;
};

/// \param fidelity  as the case file has it; null where it says nothing
FluidChoice choose_fluid(double Re, const nlohmann::json& fidelity);

/// The fluid of a lattice: quasisteady has no memory and deviates from Re = 0.1 on (paper, fig. 10).
Fluid lattice_for(double Re);

/// A quasi-steady flow was asked for where it deviates.
bool neglects_inertia(const Case& c);

}  // namespace capstan
