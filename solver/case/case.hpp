#pragma once
// One run: all inputs that determine its results, dimensionless (radius a = 1, shear rate k = 1, ambient
// viscosity mu_a = 1). parse_case makes a Case from a case file and checks it; parameters.hpp lists the keys.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "solver/case/fidelity.hpp"
#include "solver/case/words.hpp"
#include "solver/strain_laws/strain_laws.hpp"

namespace capstan {

enum class Shape { sphere, oblate, prolate, biconcave };
template <>
inline constexpr auto kWords<Shape> = std::to_array<Word<Shape>>({{Shape::sphere, "sphere"},
                                                                  {Shape::oblate, "oblate"},
                                                                  {Shape::prolate, "prolate"},
                                                                  {Shape::biconcave, "biconcave"}});

enum class BendingModel {
  variational,       ///< forces are the exact gradient of a discrete Helfrich energy
  helfrich_literal,  ///< paper eq. 31 as printed, with the signs that make it dissipative
};
template <>
inline constexpr auto kWords<BendingModel> = std::to_array<Word<BendingModel>>(
    {{BendingModel::variational, "variational"}, {BendingModel::helfrich_literal, "helfrich_literal"}});

enum class Fluid {
  quasisteady,  ///< steady lattice Boltzmann flow at every step, by multigrid (the paper's method)
  unsteady,     ///< the same with the time derivative of the flow, by backward differences
  transient,    ///< the standard lattice Boltzmann method in time (the paper's baseline)
  stokes,       ///< boundary integrals: no inertia, no walls, no grid
};
template <>
inline constexpr auto kWords<Fluid> = std::to_array<Word<Fluid>>({{Fluid::quasisteady, "quasisteady"},
                                                                  {Fluid::unsteady, "unsteady"},
                                                                  {Fluid::transient, "transient"},
                                                                  {Fluid::stokes, "stokes"}});

/// Spontaneous curvature c0 in units of 1/a: a number; or `initial`, c0 = 2 H of the initial shape at each
/// vertex, so that this shape has no bending energy (paper, section VII D: -2 kappa_0); or `uniform`, the
/// mean of 2 H over the initial shape. H > 0 on a sphere.
struct InitialCurvature {
  bool operator==(const InitialCurvature&) const = default;
};
struct UniformCurvature {
  bool operator==(const UniformCurvature&) const = default;
};
using SpontaneousCurvature = std::variant<InitialCurvature, UniformCurvature, double>;

/// A run ends at shear time `kt`. If `classified` is true it ends earlier, as soon as its label is certain,
/// and goes on beyond `kt` while it is undecided, to `at_most` at the latest.
struct Until {
  double kt = 30;
  bool classified = false;
  double at_most = 0;  ///< shear time kt, only if classified
  double last() const { return classified ? at_most : kt; }
  bool operator==(const Until&) const = default;
};

/// Intervals between the records of a run.
struct Outputs {
  double history_every = 0.1;  ///< shear time kt
  double shapes_every = 1;     ///< shear time kt; 0: no shapes
  int checkpoint_every = 0;    ///< steps; 0: checkpoints by wall-clock time only
  bool operator==(const Outputs&) const = default;
};

struct Case {
  Shape shape = Shape::sphere;
  double aspect = 1;  ///< axis of revolution over equatorial axis: oblate < 1 < prolate (eq. 45: b/a)
  const StrainLaw* law = default_strain_law();  ///< a row of strain_laws(), never null
  std::vector<double> law_constants;            ///< in the order of law->constants
  double Ca = 0;   ///< mu_a a k / E_s (eq. 1); each strain law defines its modulus E_s
  double V = 1;    ///< viscosity ratio, inner over outer (eq. 3)
  double Re = 0;   ///< rho k a^2 / mu_a (eq. 4); always 0 for stokes, and may be 0 for quasisteady
  double E_b = 0;  ///< E_B / (a^2 E_s) (eq. 2)
  BendingModel bending = BendingModel::variational;
  SpontaneousCurvature c0 = InitialCurvature{};
  Fluid fluid = Fluid::stokes;
  Until until;
  bool companion =
      true;  ///< whether the rung below is computed, too, for an estimate of the error (ladder.hpp)
  Fidelity fidelity;
  Outputs outputs;

  bool has_aspect() const { return shape == Shape::oblate || shape == Shape::prolate; }
  bool has_bending() const { return E_b > 0; }
  bool has_viscosity_ratio() const { return V != 1; }
  /// Whether the model solves an equation iteratively at every step. Boundary integrals do not at V = 1,
  /// where the velocities are given by an explicit integral.
  bool solves_for_flow() const {
    return fluid == Fluid::quasisteady || fluid == Fluid::unsteady || (fluid == Fluid::stokes && V != 1);
  }
  bool has_grid() const { return fluid != Fluid::stokes; }
  /// Whether the model is the quasisteady flow on a composite grid, and not the scheme of the paper; or the
  /// unsteady flow, which has no other grid.
  bool has_composite_grid() const {
    return fluid == Fluid::unsteady || (fluid == Fluid::quasisteady && fidelity.scheme == Scheme::tuned);
  }
  /// Whether the model has a lattice that goes forward in time or the scheme of the paper, so that Re cannot
  /// be 0.
  bool needs_inertia() const { return has_grid() && !(fluid == Fluid::quasisteady && has_composite_grid()); }
  /// Whether the numbers on the lattice can be in single or double precision.
  bool has_precision() const { return fluid == Fluid::transient || has_composite_grid(); }
  /// Whether the model can solve for a quarter of a symmetric flow.
  bool can_use_symmetry() const { return !has_grid() || has_composite_grid(); }
  bool operator==(const Case&) const = default;
};

/// Canonical form: every parameter that has an effect, defaults written out, in the order of the table
/// parameters.hpp. parse_case(to_json(c)) gives c back.
nlohmann::ordered_json to_json(const Case& c);

}  // namespace capstan
