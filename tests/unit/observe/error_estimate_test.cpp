#include "solver/observe/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/case/ladder.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

EstimatedRun run_of(const std::string& keys, double kt = 10) {
  return {.parameters = testing::parsed_case(R"({"Ca": 0.1, "E_b": 0.01, )" + keys + "}"),
          .kt = kt,
          .half_turns = 2};
}
const EstimatedRun kStokes = run_of(R"("fluid": "stokes")");
constexpr Distance kDistance{.Q = 0.02, .D_xy = 0.01, .theta = 0.04, .period = 0.03, .until_kt = 10};
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A coarser run, with larger angles between its triangles than the finer runs of these tests have: the
/// surface is smooth.
EstimatedRun smooth_run(const Case& c) { return {.parameters = c, .largest_dihedral = 100}; }
ErrorEstimate from_companion(const EstimatedRun& run, const Distance& distance) {
  return estimated_error(run, smooth_run(coarser(run.parameters).value()), distance);
}
ErrorEstimate from_rung_below(const EstimatedRun& run, const Distance& distance) {
  return estimated_error(run, smooth_run(rung_below(run.parameters).value()), distance);
}
Distance scaled(const Distance& distance, double by) {
  return {distance.Q * by, distance.D_xy * by, distance.theta * by, distance.period * by, distance.until_kt};
}

TEST(ErrorEstimate, IsProportionalToTheDistance) {
  const ErrorEstimate once = from_companion(kStokes, kDistance),
                      twice = from_companion(kStokes, scaled(kDistance, 2));
  EXPECT_DOUBLE_EQ(twice.Q, 2 * once.Q);
  EXPECT_DOUBLE_EQ(twice.D_xy, 2 * once.D_xy);
  EXPECT_DOUBLE_EQ(twice.theta, 2 * once.theta);
  EXPECT_DOUBLE_EQ(twice.period, 2 * once.period);
}

TEST(ErrorEstimate, GrowsWhereTheCompanionEndedEarlier) {
  EXPECT_DOUBLE_EQ(from_companion(run_of(R"("fluid": "stokes")", 25), kDistance).Q,
                   2.5 * from_companion(kStokes, kDistance).Q);
  EXPECT_DOUBLE_EQ(from_companion(run_of(R"("fluid": "stokes")", 5), kDistance).Q,
                   from_companion(kStokes, kDistance).Q);
}

TEST(ErrorEstimate, IsLargerOnALatticeWithoutBendingAndOnAFoldedSurface) {
  const double usual = from_companion(kStokes, kDistance).Q;
  EXPECT_GT(from_companion(run_of(R"("fluid": "quasisteady")"), kDistance).Q, usual);
  EXPECT_GT(from_companion(run_of(R"("fluid": "stokes", "fidelity": {"nodes": 162})"), kDistance).Q, usual);
  EstimatedRun other = kStokes;
  other.largest_dihedral = 61;
  EXPECT_GE(from_companion(other, scaled(kDistance, 0.1)).Q, 0.1);
  other = kStokes;
  other.parameters.E_b = 0;
  const double without_bending = from_companion(other, kDistance).Q;
  EXPECT_GT(without_bending, usual);
  other.largest_dihedral = 41;
  EXPECT_GT(from_companion(other, kDistance).Q, without_bending);
}

TEST(ErrorEstimate, IsLargeWhereTheFinerMeshOfAMembraneWithoutBendingIsNotSmoother) {
  EstimatedRun run = run_of(R"("shape": "biconcave", "fluid": "stokes")");
  EstimatedRun companion = smooth_run(coarser(run.parameters).value());
  run.parameters.E_b = companion.parameters.E_b = 0;
  run.largest_dihedral = 35;
  EXPECT_LT(estimated_error(run, companion, kDistance).Q, 0.1);
  companion.largest_dihedral = 40;
  EXPECT_GE(estimated_error(run, companion, kDistance).Q, 0.2);
  run.parameters.shape = Shape::sphere;
  EXPECT_EQ(estimated_error(run, companion, scaled(kDistance, 0.1)).Q, 0.02);
  EstimatedRun below = smooth_run(rung_below(run.parameters).value());
  run.largest_dihedral = below.largest_dihedral = 45;
  EXPECT_EQ(estimated_error(run, below, scaled(kDistance, 0.1)).Q, 0.02) << "from the rung below";
  run.parameters.E_b = companion.parameters.E_b = 0.01;
  EXPECT_LT(estimated_error(run, companion, kDistance).Q, 0.1) << "with bending stiffness";
}

TEST(ErrorEstimate, OnACoarseLatticeIsLargerForViscousRedCells) {
  const auto on_lattice = [](const std::string& keys, const std::string& fidelity) {
    return from_companion(run_of(keys + R"(, "fluid": "quasisteady", "fidelity": ")" + fidelity + '"'),
                          kDistance)
        .Q;
  };
  const std::string viscous = R"("shape": "biconcave", "V": 8)", usual = R"("shape": "biconcave", "V": 6)";
  EXPECT_GT(on_lattice(viscous, "fast"), 5 * on_lattice(usual, "fast"));
  EXPECT_EQ(on_lattice(viscous, "standard"), on_lattice(usual, "standard"));
  EXPECT_GT(on_lattice(R"("V": 0.1)", "fast"), on_lattice(R"("V": 1)", "fast"));
}

TEST(ErrorEstimate, FromTheRungBelowIsThatOfSecondOrderTimesAFactor) {
  const double ratio = 640. / 360;  // of the squares of the spacings
  EXPECT_NEAR(from_rung_below(kStokes, kDistance).Q, 1.15 * kDistance.Q / (ratio - 1), 1e-12);
  const EstimatedRun on_lattice = run_of(R"("fluid": "quasisteady")");
  EXPECT_NEAR(from_rung_below(on_lattice, kDistance).Q, kDistance.Q / (std::sqrt(ratio) - 1), 1e-12);
}

// If the error is of second order, the estimate from the rung below is 1.15 times the true error, that from
// the companion 1.95 times.
TEST(ErrorEstimate, FromTheRungBelowIsSmallerThanFromTheCompanionWhereTheOrderIsTwo) {
  const double error = 0.01;
  const auto at_distance = [](double Q) { return scaled(kDistance, Q / kDistance.Q); };
  const double neighbours = from_rung_below(kStokes, at_distance(error * (640. / 360 - 1))).Q;
  const double companion = from_companion(kStokes, at_distance(error * (640. / 160 - 1))).Q;
  EXPECT_NEAR(neighbours, 1.15 * error, 1e-12);
  EXPECT_NEAR(companion, 1.95 * error, 1e-12);
}

TEST(ErrorEstimate, OfDeformationAngleAndPeriodDoesNotVanishWhereTheyAgreeByChance) {
  Distance by_chance = kDistance;
  by_chance.D_xy = by_chance.theta = by_chance.period = 0;
  const ErrorEstimate error = from_companion(kStokes, by_chance);
  EXPECT_DOUBLE_EQ(error.D_xy, 0.75 * error.Q);
  EXPECT_DOUBLE_EQ(error.theta, 2 * error.Q);
  EXPECT_DOUBLE_EQ(error.period, 1.5 * error.Q);
}

TEST(ErrorEstimate, IsNeverZeroAndUnknownWhereTheDistanceIs) {
  const ErrorEstimate error =
      from_companion(kStokes, {.Q = 0, .D_xy = 0, .theta = kUnknown, .period = kUnknown, .until_kt = 10});
  EXPECT_GT(error.Q, 0);
  EXPECT_GT(error.D_xy, 0);
  EXPECT_TRUE(std::isnan(error.theta));
  EXPECT_TRUE(std::isnan(error.period));
  EXPECT_TRUE(std::isnan(from_companion(kStokes, Distance{}).Q)) << "the runs have no time in common";
}

TEST(Confirmation, NeedsTheSameLabelAndAnErrorBelowTheMargin) {
  const ErrorEstimate error{.Q = 0.02, .D_xy = 0, .theta = 0, .period = 0};
  EXPECT_TRUE(is_confirmed(Motion::tumbling, 0.03, Motion::tumbling, error));
  EXPECT_FALSE(is_confirmed(Motion::tumbling, 0.01, Motion::tumbling, error));
  EXPECT_FALSE(is_confirmed(Motion::tumbling, 0.03, Motion::transition, error));
  EXPECT_FALSE(is_confirmed(Motion::undecided, 0.03, Motion::undecided, error));
}

}  // namespace
}  // namespace capstan
