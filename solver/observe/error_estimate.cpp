#include "solver/observe/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/mesh/surface_quality.hpp"

namespace capstan {
namespace {

struct Calibration {
  double factor;  ///< true error over distance to the companion: at most this in 97 % of the random scenes
  double floor;   ///< of Q: where the two rungs agree better than this, they do so by chance
};

constexpr Calibration kCoarsest{1.3, 0.01}, kCoarse{0.65, 0.002}, kBoundaryIntegrals{0.65, 8e-4},
    kLattice{1, 1e-3};
/// On the coarsest mesh both rungs lack the dimples of a red cell.
constexpr Calibration kCoarsestDimples{1.3, 0.04};
/// In a thin inner fluid the error falls more slowly with the spacing. Coarse lattices resolve red cells with
/// a viscous inner fluid so poorly that two rungs can agree on the wrong motion.
constexpr Calibration kLatticeThin{1.4, 1e-3}, kCoarseLatticeViscous{6, 1e-3};
/// Without bending stiffness finer meshes have finer wrinkles.
constexpr Calibration kWithoutBending{0.9, 2e-3}, kBeginsToWrinkle{1.5, 0.05};
constexpr double kWrinkling = 40;  // degrees
/// Wrinkles as wide as the mesh do not converge.
constexpr Calibration kFolded{1.5, 0.2};

Calibration calibration_of_lattice(const Case& c) {
  constexpr double kThin = 0.2, kViscous = 6.5, kCoarseSpacing = 0.15;
  if (c.V < kThin) return kLatticeThin;
  const bool is_viscous = c.shape == Shape::biconcave && c.V > kViscous;
  return is_viscous && c.fidelity.dx > kCoarseSpacing ? kCoarseLatticeViscous : kLattice;
}

Calibration calibration_of_rung(const Case& c) {
  if (c.has_grid()) return calibration_of_lattice(c);
  if (c.fidelity.nodes <= 162) return c.shape == Shape::biconcave ? kCoarsestDimples : kCoarsest;
  return c.fidelity.nodes < 642 ? kCoarse : kBoundaryIntegrals;
}

Calibration larger(const Calibration& a, const Calibration& b) {
  return {std::max(a.factor, b.factor), std::max(a.floor, b.floor)};
}

Calibration calibration_of(const EstimatedRun& run) {
  Calibration calibration = calibration_of_rung(run.parameters);
  const bool has_bending = run.parameters.has_bending();
  if (!has_bending) calibration = larger(calibration, kWithoutBending);
  if (!has_bending && run.largest_dihedral > kWrinkling) calibration = larger(calibration, kBeginsToWrinkle);
  if (run.largest_dihedral > kFoldedEdge) calibration = larger(calibration, kFolded);
  return calibration;
}

/// NaN if the distance is.
double larger_unless_unknown(double distance, double other) {
  return std::isnan(distance) ? distance : std::max(distance, other);
}

}  // namespace

ErrorEstimate estimated_error(const EstimatedRun& run, const Distance& to_companion) {
  constexpr double kFewTurns = 0.5, kLargest = 2;  // two Q differ by less, since |Q| < 1
  const Calibration calibration = calibration_of(run);
  const double longer = to_companion.until_kt > 0 ? std::max(1., run.kt / to_companion.until_kt)
                                                  : std::numeric_limits<double>::quiet_NaN();
  const double Q = std::clamp(longer * calibration.factor * to_companion.Q, calibration.floor, kLargest);
  const auto scaled = [&](double distance, double least) {
    return larger_unless_unknown(longer * calibration.factor * distance, least);
  };
  return {.Q = std::isnan(longer) ? longer : Q,
          .D_xy = scaled(to_companion.D_xy, 0.75 * Q),
          .theta = std::min(scaled(to_companion.theta, 2 * Q), std::numbers::pi / 2),
          .period = scaled(to_companion.period, 3 * Q / std::max(kFewTurns, run.half_turns))};
}

bool is_confirmed(Motion motion, double margin, Motion of_companion, const ErrorEstimate& error) {
  return motion != Motion::undecided && motion == of_companion && error.Q < margin;
}

}  // namespace capstan
