#pragma once
// One run: every input that decides its outcome, dimensionless (radius a = 1, shear rate k = 1, ambient
// viscosity mu_a = 1). A Case that exists is valid; parse.hpp makes them.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>

#include "solver/case/fidelity.hpp"

namespace capstan {

enum class Shape { sphere, oblate, prolate, biconcave };
enum class Law { neo_hookean, skalak };
enum class BendingModel {
  variational,       ///< forces are the exact gradient of a discrete Helfrich energy
  helfrich_literal,  ///< paper eq. 31 as printed, with the signs that make it dissipative
};
enum class Fluid {
  quasisteady,  ///< steady lattice Boltzmann flow at every step, by multigrid (the paper's method)
  transient,    ///< the standard lattice Boltzmann method in time (the paper's baseline)
  stokes,       ///< boundary integrals: no inertia, no walls, no grid
};

/// Spontaneous curvature c0 in units 1/a: a number, or `initial`: c0 = -2 H0 vertex by vertex, so that the
/// initial shape is free of bending (paper, section VII D), or `uniform`: the mean of that over the membrane.
struct InitialCurvature {
  bool operator==(const InitialCurvature&) const = default;
};
struct UniformCurvature {
  bool operator==(const UniformCurvature&) const = default;
};
using SpontaneousCurvature = std::variant<InitialCurvature, UniformCurvature, double>;

/// When a run ends: at shear time `kt`, or earlier when its class is certain, if that is wanted.
struct Until {
  double kt = 30;
  bool classified = false;
  bool operator==(const Until&) const = default;
};

/// What a run records. Intervals of shear time kt; 0 switches the shapes off.
struct Outputs {
  double history_every = 0.1;
  double shapes_every = 1;
  int checkpoint_every = 0;  ///< steps; 0: as time goes by only
  bool operator==(const Outputs&) const = default;
};

struct Case {
  Shape shape = Shape::sphere;
  double aspect = 1;  ///< axis of revolution over equatorial axis: oblate < 1 < prolate (eq. 45: b/a)
  Law law = Law::neo_hookean;
  double C = 0;    ///< Skalak's resistance to area dilation (eq. 28)
  double Ca = 0;   ///< mu_a a k / E_s (eq. 1); E_s = 3 G neo-Hookean, E_s = 2 G Skalak
  double V = 1;    ///< inner over outer viscosity (eq. 3)
  double Re = 0;   ///< rho k a^2 / mu_a (eq. 4); 0 for fluid stokes
  double E_b = 0;  ///< E_B / (a^2 E_s) (eq. 2)
  BendingModel bending = BendingModel::variational;
  SpontaneousCurvature c0 = InitialCurvature{};
  Fluid fluid = Fluid::stokes;
  Until until;
  Fidelity fidelity;
  Outputs outputs;

  bool has_bending() const { return E_b > 0; }
  bool has_viscosity_ratio() const { return V != 1; }
  /// An equation to a tolerance at every step; boundary integrals at V = 1 give the flow directly.
  bool solves_for_flow() const { return fluid == Fluid::quasisteady || (fluid == Fluid::stokes && V != 1); }
  bool has_grid() const { return fluid != Fluid::stokes; }
  /// The quasi-steady flow on a composite of grids, not the paper's own scheme.
  bool has_composite_grid() const { return fluid == Fluid::quasisteady && fidelity.scheme == Scheme::tuned; }
  /// A lattice whose numbers may be of either precision.
  bool has_precision() const { return fluid == Fluid::transient || has_composite_grid(); }
  /// A model that can solve for a quarter of the flow.
  bool can_use_symmetry() const { return !has_grid() || has_composite_grid(); }
  bool operator==(const Case&) const = default;
};

/// Canonical form: every key that has an effect, defaults written out, in a fixed order.
/// parse_case(to_json(c)) gives c back.
nlohmann::ordered_json to_json(const Case& c);

/// The word a case file uses for a value, e.g. "neo-hookean".
std::string_view to_string(Shape shape);
std::string_view to_string(Law law);
std::string_view to_string(BendingModel model);
std::string_view to_string(Fluid fluid);

}  // namespace capstan
