#include "solver/observe/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "solver/mesh/surface_quality.hpp"

namespace capstan {
namespace {

struct Calibration {
  double factor;  ///< true error over the extrapolated one: at most this in 97 % of the random scenes
  double floor;   ///< of Q: where the two runs agree better than this, they do so by chance
};

struct RungCalibration {
  int nodes;  ///< of the finest rung that it is for
  Calibration usual;
  double floor_of_red_cells;  ///< coarse meshes lack their dimples
};

/// Of scenes that converge slowly or not at all.
struct WrinkleCalibration {
  Calibration without_bending;            ///< finer meshes have finer wrinkles
  Calibration begins_to_wrinkle, folded;  ///< wrinkles as wide as the mesh do not converge
};

struct BoundaryIntegrals {
  std::span<const RungCalibration> rungs;  ///< the last is for all finer ones, too
  WrinkleCalibration wrinkles;
};

constexpr int kFinest = std::numeric_limits<int>::max();
constexpr RungCalibration kTwiceTheSpacingRungs[] = {
    {162, {3.9, 0.01}, 0.04}, {362, {1.95, 0.002}, 0.002}, {kFinest, {1.95, 8e-4}, 8e-4}};
constexpr RungCalibration kNextRungs[] = {{92, {2.3, 0.01}, 0.04},
                                          {162, {1.15, 0.003}, 0.02},
                                          {362, {1.15, 0.0015}, 0.0015},
                                          {kFinest, {1.15, 8e-4}, 8e-4}};
constexpr BoundaryIntegrals kTwiceTheSpacing{
    .rungs = kTwiceTheSpacingRungs,
    .wrinkles = {.without_bending = {2.7, 2e-3}, .begins_to_wrinkle = {4.5, 0.05}, .folded = {4.5, 0.2}}};
constexpr BoundaryIntegrals kNextRung{
    .rungs = kNextRungs,
    .wrinkles = {.without_bending = {1.5, 3e-3}, .begins_to_wrinkle = {2.2, 3e-3}, .folded = {2.2, 0.2}}};

/// In a thin inner fluid the error falls more slowly with the spacing. Coarse lattices resolve red cells with
/// a viscous inner fluid so poorly that two rungs can agree on the wrong motion.
constexpr Calibration kLattice{1, 1e-3}, kLatticeThin{1.4, 1e-3}, kCoarseLatticeViscous{6, 1e-3};
constexpr WrinkleCalibration kWrinklesOnLattice{
    .without_bending = {0.9, 2e-3}, .begins_to_wrinkle = {1.5, 0.05}, .folded = {1.5, 0.2}};

/// Of the spacings of two rungs.
double ratio_of_spacings(const Case& run, const Case& coarser) {
  return std::sqrt((run.fidelity.nodes - 2.) / (coarser.fidelity.nodes - 2.));
}

bool are_neighbours(const Case& run, const Case& coarser) { return ratio_of_spacings(run, coarser) < 1.75; }

/// The error of order p, over the distance.
double extrapolated(const Case& run, const Case& coarser) {
  const double ratio = ratio_of_spacings(run, coarser);
  return 1 / ((run.has_grid() ? ratio : ratio * ratio) - 1);
}

Calibration calibration_of_lattice(const Case& c) {
  constexpr double kThin = 0.2, kViscous = 6.5, kCoarseSpacing = 0.15;
  if (c.V < kThin) return kLatticeThin;
  const bool is_viscous = c.shape == Shape::biconcave && c.V > kViscous;
  return is_viscous && c.fidelity.dx > kCoarseSpacing ? kCoarseLatticeViscous : kLattice;
}

Calibration calibration_of_rung(const Case& c, const BoundaryIntegrals& calibration) {
  const auto& rung = *std::ranges::find_if(
      calibration.rungs, [&](const RungCalibration& each) { return c.fidelity.nodes <= each.nodes; });
  return {rung.usual.factor, c.shape == Shape::biconcave ? rung.floor_of_red_cells : rung.usual.floor};
}

Calibration larger(const Calibration& a, const Calibration& b) {
  return {std::max(a.factor, b.factor), std::max(a.floor, b.floor)};
}

/// Whether the surface is nearly as rough on the finer mesh as on the coarser one. Then its wrinkles are as
/// narrow as each mesh allows.
bool is_rough_on_both(const EstimatedRun& run, const EstimatedRun& coarser) {
  constexpr double kRough = 30;  // degrees
  const double smoother = are_neighbours(run.parameters, coarser.parameters) ? 0.9 : 0.8;
  return run.largest_dihedral > kRough && run.largest_dihedral > smoother * coarser.largest_dihedral;
}

Calibration calibration_without_bending(const EstimatedRun& run, const EstimatedRun& coarser,
                                        const WrinkleCalibration& wrinkles) {
  constexpr Calibration kRoughSphere{0, 0.02};
  Calibration calibration = wrinkles.without_bending;
  if (run.largest_dihedral > kWrinkledEdge) calibration = larger(calibration, wrinkles.begins_to_wrinkle);
  if (is_rough_on_both(run, coarser))
    calibration = larger(calibration, run.parameters.shape == Shape::sphere ? kRoughSphere : wrinkles.folded);
  return calibration;
}

Calibration calibration_of(const EstimatedRun& run, const EstimatedRun& coarser, const Calibration& of_rung,
                           const WrinkleCalibration& wrinkles) {
  Calibration calibration = of_rung;
  if (!run.parameters.has_bending())
    calibration = larger(calibration, calibration_without_bending(run, coarser, wrinkles));
  if (run.largest_dihedral > kFoldedEdge) calibration = larger(calibration, wrinkles.folded);
  return calibration;
}

Calibration calibration_of(const EstimatedRun& run, const EstimatedRun& coarser) {
  const Case& c = run.parameters;
  if (c.has_grid()) return calibration_of(run, coarser, calibration_of_lattice(c), kWrinklesOnLattice);
  const BoundaryIntegrals& calibration = are_neighbours(c, coarser.parameters) ? kNextRung : kTwiceTheSpacing;
  return calibration_of(run, coarser, calibration_of_rung(c, calibration), calibration.wrinkles);
}

/// NaN if the distance is.
double larger_unless_unknown(double distance, double other) {
  return std::isnan(distance) ? distance : std::max(distance, other);
}

}  // namespace

ErrorEstimate estimated_error(const EstimatedRun& run, const EstimatedRun& coarser,
                              const Distance& distance) {
  constexpr double kFewTurns = 0.5, kLargest = 2;  // two Q differ by less, since |Q| < 1
  const Calibration calibration = calibration_of(run, coarser);
  const double longer = distance.until_kt > 0 ? std::max(1., run.kt / distance.until_kt)
                                              : std::numeric_limits<double>::quiet_NaN();
  const double factor = longer * calibration.factor * extrapolated(run.parameters, coarser.parameters);
  const double Q = std::clamp(factor * distance.Q, calibration.floor, kLargest);
  const auto scaled = [&](double of_distance, double least) {
    return larger_unless_unknown(factor * of_distance, least);
  };
  return {.Q = std::isnan(longer) ? longer : Q,
          .D_xy = scaled(distance.D_xy, 0.75 * Q),
          .theta = std::min(scaled(distance.theta, 2 * Q), std::numbers::pi / 2),
          .period = scaled(distance.period, 3 * Q / std::max(kFewTurns, run.half_turns))};
}

bool is_confirmed(Motion motion, double margin, Motion of_coarser, const ErrorEstimate& error) {
  return motion != Motion::undecided && motion == of_coarser && error.Q < margin;
}

}  // namespace capstan
