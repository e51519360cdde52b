// The flow on the composite grid equals that on a uniform grid and that on all four quarters, and takes a few
// cycles.
#include "solver/fluid/quasisteady/quasisteady_flow.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "solver/membrane/membrane.hpp"
#include "solver/mesh/shapes.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

/// A sheared capsule with the forces of its membrane.
struct ShearedCapsule {
  Icosphere sphere = make_icosphere(3);
  Points initial, positions, forces;

  explicit ShearedCapsule(const std::string& shape) {
    const Case c = testing::parsed_case(
        R"({"shape": ")" + shape +
        R"(", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": 0.4, "fluid": "quasisteady", "fidelity": "fast"})");
    initial = initial_positions(c, sphere);
    positions = initial;
    positions.row(0) += 0.1 * initial.row(1);
    Membrane(c, sphere.mesh, initial, whole()).forces(positions, forces);
  }
  Orbits symmetric() const { return Orbits::of(initial); }
  Orbits whole() const { return Orbits::without_symmetry(int(initial.cols())); }
};

struct RedCell : ShearedCapsule {
  RedCell() : ShearedCapsule("biconcave") {}
};

constexpr QuasisteadyOptions kOptions{.dx = 0.2, .box = 25.6, .Re = 0.05, .V = 4, .tolerance = 1e-7};

template <class T>
Points velocities(const ShearedCapsule& cell, Orbits orbits, const QuasisteadyOptions& options) {
  QuasisteadyFlow<T> flow(cell.sphere.mesh, std::move(orbits), options);
  Points u;
  const FlowReport report = flow.solve(0, cell.positions, cell.forces, u);
  EXPECT_TRUE(report.converged) << report.reason;
  return u;
}

double difference(const Points& a, const Points& b) { return (a - b).norm() / b.norm(); }

// Measured: 3e-4.
TEST(QuasisteadyFlow, GivesTheVelocitiesOfTheUniformGridToOnePartInAThousand) {
  const RedCell cell;
  QuasisteadyOptions uniform = kOptions;
  uniform.is_uniform = true;
  for (double V : {1.0, 4.0}) {
    QuasisteadyOptions composite = kOptions;
    composite.V = uniform.V = V;
    EXPECT_LT(difference(velocities<double>(cell, cell.symmetric(), composite),
                         velocities<double>(cell, cell.symmetric(), uniform)),
              1e-3)
        << "V = " << V;
  }
}

constexpr double kNarrowBox = 9.6;

/// Solves for the flow around a red cell that is stretched to this half-length, checks its velocities against
/// those on the uniform grid, and returns the grids.
std::vector<MomentGrid<double>> grids_around(double half_length) {
  RedCell cell;
  cell.positions.row(0) *= half_length / cell.positions.row(0).maxCoeff();
  QuasisteadyOptions composite = kOptions, uniform = kOptions;
  composite.box = uniform.box = kNarrowBox, composite.tolerance = 1e-9;
  uniform.is_uniform = true;
  QuasisteadyFlow<double> flow(cell.sphere.mesh, cell.symmetric(), composite);
  Points u;
  EXPECT_TRUE(flow.solve(0, cell.positions, cell.forces, u).converged);
  EXPECT_LT(difference(u, velocities<double>(cell, cell.symmetric(), uniform)), 1e-3);
  return {flow.grids().begin(), flow.grids().end()};
}

// A long capsule: the box of a grid spans the domain in x, with interpolated sides in y and z only.
TEST(QuasisteadyFlow, BoxThatSpansTheDomainInXOnlyConvergesToTheVelocitiesOfTheUniformGrid) {
  const auto grids = grids_around(3.2);
  const int across = int(std::lround(kNarrowBox / kOptions.dx));
  int spanning = 0;
  for (int grid = 0; grid < int(grids.size()); ++grid)
    spanning += !grids[grid].is_whole() && grids[grid].box().size(0) == across >> grid;
  EXPECT_GT(spanning, 0);
}

// The ghosts of such a side are interpolated from the last coarse cell of the domain and the ghost beyond it.
TEST(QuasisteadyFlow, BoxThatEndsTwoCellsBeforeTheDomainConvergesToTheVelocitiesOfTheUniformGrid) {
  EXPECT_EQ(grids_around(2.7).front().box().hi[0], 22);  // of 24
}

TEST(QuasisteadyFlow, OnAQuarterIsThatOnTheWholeDomain) {
  const RedCell cell;
  EXPECT_LT(difference(velocities<double>(cell, cell.symmetric(), kOptions),
                       velocities<double>(cell, cell.whole(), kOptions)),
            1e-6);
}

TEST(QuasisteadyFlow, InSinglePrecisionIsExactToOnePartInTenThousand) {
  const RedCell cell;
  QuasisteadyOptions options = kOptions;
  options.tolerance = 1e-5;
  EXPECT_LT(difference(velocities<float>(cell, cell.symmetric(), options),
                       velocities<double>(cell, cell.symmetric(), kOptions)),
            1e-4);
}

TEST(QuasisteadyFlow, DoesNotDependOnTheNumberOfThreads) {
  const RedCell cell;
  omp_set_num_threads(1);
  const Points alone = velocities<float>(cell, cell.whole(), {.dx = 0.2, .V = 4});
  omp_set_num_threads(2);
  const Points together = velocities<float>(cell, cell.whole(), {.dx = 0.2, .V = 4});
  omp_set_num_threads(1);
  EXPECT_EQ(alone, together);
}

/// Relative errors of the velocities: of the undisturbed flow, and after each cycle that starts from it.
std::vector<double> errors_of_cycles(const ShearedCapsule& cell, double V, double dx) {
  QuasisteadyOptions options = kOptions;
  options.V = V, options.dx = dx, options.Re = 0;
  const Points exact = velocities<double>(cell, cell.symmetric(), options);
  options.tolerance = 1e300;  // a solve is one cycle; the next one at the same time continues from its result
  QuasisteadyFlow<double> flow(cell.sphere.mesh, cell.symmetric(), options);
  Points u = Points::Zero(3, exact.cols());
  u.row(0) = cell.positions.row(1);
  std::vector<double> errors = {difference(u, exact)};
  for (int cycle = 0; cycle < 6; ++cycle) {
    flow.solve(0, cell.positions, cell.forces, u);
    errors.push_back(difference(u, exact));
  }
  return errors;
}

double first_contraction(const std::vector<double>& errors) { return errors[1] / errors[0]; }
double mean_contraction(const std::vector<double>& errors) { return std::pow(errors[5] / errors[0], 1. / 5); }

// Measured at dx = 0.2 for the first cycle and the mean of five:
//     V        red cell        sphere
//     0.05     0.14, 0.28      0.06, 0.17
//     0.2      0.12, 0.20      0.05, 0.17
//     0.3      0.19, 0.33      0.07, 0.28
//     1        0.12, 0.34      0.15, 0.32
//     4        0.08, 0.31      0.07, 0.30
//     10       0.07, 0.32      0.05, 0.30
//     20       0.08, 0.35      0.07, 0.30
TEST(QuasisteadyFlow, FirstCycleLeavesAFifthOfTheErrorAndLaterOnesAThird) {
  for (double V : {0.05, 0.2, 1.0, 4.0, 10.0, 20.0})
    for (double dx : {0.2, 0.1}) {
      const auto errors = errors_of_cycles(RedCell(), V, dx);
      EXPECT_LT(first_contraction(errors), V < 1 ? 1. / 5 : 1. / 6) << "V = " << V << ", dx = " << dx;
      EXPECT_LT(mean_contraction(errors), V > 10 ? 0.36 : 0.35) << "V = " << V << ", dx = " << dx;
    }
}

TEST(QuasisteadyFlow, CyclesConvergeInAVeryThinAndInAVeryViscousInnerFluid) {
  for (double V : {0.02, 50.0})
    for (const char* shape : {"biconcave", "sphere"}) {
      const auto errors = errors_of_cycles(ShearedCapsule(shape), V, 0.2);
      EXPECT_LT(first_contraction(errors), 0.2) << "V = " << V << ", " << shape;
      EXPECT_LT(mean_contraction(errors), 0.5) << "V = " << V << ", " << shape;
    }
}

/// Relative error after steps of one cycle, each of which starts from the linear extrapolation of the two
/// steps before it.
double error_after_steps_of_one_cycle(const ShearedCapsule& capsule, double V, int steps) {
  QuasisteadyOptions options = kOptions;
  options.V = V, options.Re = 0;  // a solve takes a part of convection from the flow before it
  const Points exact = velocities<double>(capsule, capsule.symmetric(), options);
  options.tolerance = 1e300;
  QuasisteadyFlow<double> flow(capsule.sphere.mesh, capsule.symmetric(), options);
  Points u;
  for (int step = 0; step < steps; ++step) flow.solve(step, capsule.positions, capsule.forces, u);
  return difference(u, exact);
}

// Measured after 60 steps: at most 1e-6 up to V = 10; 8e-6 for the sphere, and 2e-3 for the red cell, at V
// = 20.
TEST(QuasisteadyFlow, StepsOfOneCycleConvergeWhileTheMembraneIsAtRest) {
  for (const char* shape : {"sphere", "biconcave"}) {
    const ShearedCapsule capsule(shape);
    for (double V : {0.05, 0.1, 0.5, 1.0, 4.0, 10.0})
      EXPECT_LT(error_after_steps_of_one_cycle(capsule, V, 60), 1e-5) << "V = " << V << ", " << shape;
  }
  EXPECT_LT(error_after_steps_of_one_cycle(ShearedCapsule("sphere"), 20, 60), 1e-4);
  EXPECT_LT(error_after_steps_of_one_cycle(ShearedCapsule("biconcave"), 20, 60), 5e-3);
}

TEST(QuasisteadyFlow, ReportsAReasonForACapsuleOutsideOfTheDomain) {
  RedCell cell;
  cell.positions.row(1).array() += 6.2;
  QuasisteadyFlow<float> flow(cell.sphere.mesh, cell.whole(), {.dx = 0.2});
  Points u;
  const FlowReport report = flow.solve(0, cell.positions, cell.forces, u);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

}  // namespace
}  // namespace capstan
