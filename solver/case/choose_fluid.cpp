#include "solver/case/choose_fluid.hpp"

#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

bool is_papers(const nlohmann::json& fidelity) {
  if (!fidelity.is_object()) return fidelity == "paper";
  return fidelity.value("scheme", nlohmann::json(fidelity.value("preset", nlohmann::json()))) == "paper";
}

/// A setting in the case file that only a lattice has, e.g. "fidelity/dx"; "" if there is none. The time step
/// kdt counts as one, because with boundary integrals the stepper chooses the time step.
std::string lattice_setting(const nlohmann::json& fidelity) {
  if (fidelity == "paper") return "fidelity";
  if (!fidelity.is_object()) return "";
  for (const char* key : {"dx", "box", "scheme", "precision", "kdt"})
    if (fidelity.contains(key)) return std::string("fidelity/") + key;
  return fidelity.contains("preset") && fidelity["preset"] == "paper" ? "fidelity/preset" : "";
}

}  // namespace

bool needs_inertia(Fluid fluid, const nlohmann::json& fidelity) {
  return fluid == Fluid::unsteady || fluid == Fluid::transient ||
         (fluid == Fluid::quasisteady && is_papers(fidelity));
}

Fluid lattice_for(double Re) { return Re < 0.1 ? Fluid::quasisteady : Fluid::unsteady; }

bool neglects_inertia(const Case& c) {
  return c.fluid == Fluid::quasisteady && lattice_for(c.Re) != Fluid::quasisteady;
}

FluidChoice choose_fluid(double Re, const nlohmann::json& fidelity) {
  const std::string setting = lattice_setting(fidelity), at = "Re = " + shown(Re);
  if (!setting.empty() && lattice_for(Re) == Fluid::quasisteady)
    return {Fluid::quasisteady,
            setting + " is a setting of a lattice; at " + at + " its flow may be taken as steady"};
  if (!setting.empty())
    return {Fluid::unsteady,
            setting + " is a setting of a lattice; at " + at + " its flow has to follow in time"};
  if (Re > kMaxStokesRe)
    return {Fluid::unsteady,
            at + " is above " + shown(kMaxStokesRe) + ", so the inertia of the fluid matters"};
  return {Fluid::stokes, "neither inertia (" + at +
                             ") nor walls nor a setting of a lattice were asked for; "
                             "boundary integrals are then the cheapest at equal accuracy"};
}

}  // namespace capstan
