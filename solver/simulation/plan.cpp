#include "solver/simulation/plan.hpp"

#include "solver/case/units.hpp"
#include "solver/fluid/paper/paper_flow.hpp"
#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/fluid/stokes/stokes_flow.hpp"
#include "solver/fluid/transient/transient_flow.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/simulation/runge_kutta_chebyshev.hpp"

namespace capstan {

Orbits symmetry_of(const Case& c, const Points& initial) {
  if (c.can_use_symmetry() && c.fidelity.symmetry == Symmetry::automatic) return Orbits::of(initial);
  return Orbits::without_symmetry(int(initial.cols()));
}

namespace {

std::unique_ptr<FlowModel> make_papers_flow(const Case& c, const TriangleMesh& mesh) {
  const Fidelity& f = c.fidelity;
  return std::make_unique<PaperFlow>(
      mesh, PaperOptions{.dx = f.dx, .box = f.box, .Re = c.Re, .V = c.V, .tolerance = f.tolerance});
}

std::unique_ptr<FlowModel> make_composite(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                          const Orbits& orbits) {
  const Fidelity& f = c.fidelity;
  const QuasisteadyOptions options{.dx = f.dx,
                                   .box = f.box,
                                   .Re = c.Re,
                                   .V = c.V,
                                   .volume = volume(initial, mesh.faces),
                                   .tolerance = f.tolerance,
                                   .is_unsteady = c.fluid == Fluid::unsteady};
  if (f.precision == Precision::double_)
    return std::make_unique<QuasisteadyFlow<double>>(mesh, orbits, options);
  return std::make_unique<QuasisteadyFlow<float>>(mesh, orbits, options);
}

std::unique_ptr<FlowModel> make_transient(const Case& c, const TriangleMesh& mesh) {
  const LatticeOptions options{.units = transient_units(c), .box = c.fidelity.box, .V = c.V};
  if (c.fidelity.precision == Precision::double_)
    return std::make_unique<TransientFlow<double>>(mesh, options);
  return std::make_unique<TransientFlow<float>>(mesh, options);
}

std::unique_ptr<FlowModel> make_stokes(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                       const Orbits& orbits) {
  return std::make_unique<StokesFlow>(
      mesh, orbits,
      StokesOptions{.V = c.V, .volume = volume(initial, mesh.faces), .tolerance = c.fidelity.tolerance});
}

}  // namespace

std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                     const Orbits& orbits) {
  switch (c.fluid) {
    case Fluid::transient:
      return make_transient(c, mesh);
    case Fluid::stokes:
      return make_stokes(c, mesh, initial, orbits);
    case Fluid::quasisteady:
    case Fluid::unsteady:
      break;
  }
  return c.has_composite_grid() ? make_composite(c, mesh, initial, orbits) : make_papers_flow(c, mesh);
}

std::unique_ptr<TimeStepper> make_stepper(const Case& c, std::optional<double> imposed_kdt) {
  if (imposed_kdt) return std::make_unique<AdamsBashforth2>(*imposed_kdt);
  if (c.fidelity.stepper == Stepper::runge_kutta_chebyshev) return std::make_unique<RungeKuttaChebyshev>();
  return std::make_unique<AdamsBashforth2>(c.fidelity.kdt);
}

}  // namespace capstan
