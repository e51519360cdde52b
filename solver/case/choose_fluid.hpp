#pragma once
// The flow model of a case that leaves the choice to the solver ("fluid": "auto", the default).
//
// Boundary integrals are the cheapest at equal accuracy (studies/cross_validation). But they
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

/// The Reynolds number of the paper's simulations, for a case that gives none and needs inertia.
inline constexpr double kPaperRe = 0.05;

/// Whether a lattice model cannot have Re = 0: those that go forward in time, and the scheme of the paper.
/// \param fidelity  value of that key in the case file; null if it is not given
bool needs_inertia(Fluid fluid, const nlohmann::json& fidelity);

/// The lattice model for a Reynolds number: quasisteady below 0.1, else unsteady. Without the time derivative
/// Q = D_xy (cos 2 theta, sin 2 theta) is wrong by up to 0.07 Re (studies/fig10). At Re = 0.1 this is the
/// error of the lattice at fidelity fast.
Fluid lattice_for(double Re);

/// Whether the case has the quasisteady model at a Reynolds number that needs the unsteady one.
bool neglects_inertia(const Case& c);

}  // namespace capstan
