#pragma once
// The flow model of a case that leaves the choice to the solver ("fluid": "auto", the default).
//
// At equal cost the errors of boundary integrals are 7 to 100 times smaller than those of a lattice. But they
// have no inertia, no walls and no grid: a case that requires one of these is computed on a lattice.
#include <nlohmann/json.hpp>
#include <string>

#include "solver/case/case.hpp"

namespace capstan {

/// Up to this Reynolds number inertia is neglected: Re = 0.05 changes the deformation of a sphere by 0.5 %.
inline constexpr double kMaxStokesRe = 0.1;

struct FluidChoice {
  Fluid fluid;
  std::string reason;
};

/// \param fidelity  value of that key in the case file; null if it is not given
FluidChoice choose_fluid(double Re, const nlohmann::json& fidelity);

/// The lattice model for a Reynolds number: quasisteady below 0.1, where its error starts to grow (paper,
/// fig. 10).
Fluid lattice_for(double Re);

/// Whether the case has the quasisteady model at a Reynolds number that needs the transient one.
bool neglects_inertia(const Case& c);

}  // namespace capstan
