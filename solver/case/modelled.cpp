#include "solver/case/modelled.hpp"

#include "solver/case/shown_number.hpp"
#include "solver/case/units.hpp"
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

std::string capsule(const Case& c) {
  if (c.shape == Shape::sphere) return "capsule: sphere";
  const std::string aspect = c.has_aspect() ? " spheroid, b/a = " + shown(c.aspect) : "";
  return "capsule: " + std::string(to_string(c.shape)) + aspect + ", inclined by pi/4 in the plane of shear";
}

std::string spontaneous_curvature(const SpontaneousCurvature& c0) {
  if (std::holds_alternative<InitialCurvature>(c0)) return "that of the initial shape at each vertex";
  if (std::holds_alternative<UniformCurvature>(c0)) return "the mean of the initial shape";
  return shown(std::get<double>(c0));
}

std::string membrane(const Case& c) {
  std::string text = "membrane: " + std::string(c.law->name);
  for (std::size_t i = 0; i < c.law_constants.size(); ++i)
    text += ", " + std::string(c.law->constants[i].key) + " = " + shown(c.law_constants[i]);
  text += " (" + std::string(c.law->modulus) + "), " + std::to_string(c.fidelity.nodes) + " nodes";
  if (!c.has_bending()) return text;
  return text + "; bending " + std::string(to_string(c.bending)) + ", spontaneous curvature " +
         spontaneous_curvature(c.c0);
}

std::string fluids(const Case& c) {
  if (!c.has_viscosity_ratio()) return "fluids: one viscosity inside and outside";
  return c.V > 1 ? "fluids: the inner one has the larger viscosity"
                 : "fluids: the inner one has the smaller viscosity";
}

std::string lattice(const Case& c) {
  switch (c.fluid) {
    case Fluid::transient:
      return "lattice Boltzmann flow in time";
    case Fluid::unsteady:
      return "lattice Boltzmann flow with its time derivative";
    default:
      return "lattice Boltzmann flow, steady at every step";
  }
}

std::string grid(const Case& c) {
  const std::string dx = "dx = " + shown(c.fidelity.dx);
  if (c.has_composite_grid()) return "grids of " + dx + " around the capsule and coarser ones farther away";
  return "one grid of " + dx + " with the paper's coupling, of first order in dx";
}

std::string flow(const Case& c) {
  if (!c.has_grid()) return "flow: stokes, by boundary integrals over the membrane";
  return "flow: " + std::string(to_string(c.fluid)) + ", " + lattice(c) + ", on " + grid(c);
}

std::string walls(const Case& c) {
  return "walls: two that move, " + shown(c.fidelity.box) + " apart in y; periodic in x and z";
}

std::string time_step(const Case& c) {
  if (c.fluid == Fluid::transient) return "time: the equal steps of the lattice";
  return c.fidelity.stepper == Stepper::runge_kutta_chebyshev ? "time: rkc2, steps chosen by their error"
                                                              : "time: ab2, equal steps";
}

}  // namespace

std::vector<std::string> modelled(const Case& c) {
  std::vector<std::string> phrases = {capsule(c), membrane(c), fluids(c), flow(c)};
  if (c.has_grid()) phrases.push_back(walls(c));
  phrases.push_back(time_step(c));
  if (c.until.classified)
    phrases.emplace_back(
        "end: as soon as more time would not change the label; beyond kt = " + shown(c.until.kt) +
        " only while the motion is undecided, to kt = " + shown(c.until.at_most) + " at the latest");
  return phrases;
}

std::optional<double> equal_time_step(const Case& c) {
  if (c.fluid == Fluid::transient) return transient_units(c).kdt;
  return c.fidelity.kdt > 0 ? std::optional(c.fidelity.kdt) : std::nullopt;
}

}  // namespace capstan
