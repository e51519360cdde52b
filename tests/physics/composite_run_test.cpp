// Whole runs on the composite grid: the same answer as on the uniform grid, on a quarter and on two threads.
#include <gtest/gtest.h>
#include <omp.h>

#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/membrane/membrane.hpp"
#include "solver/mesh/shapes.hpp"
#include "solver/observe/deformation.hpp"
#include "solver/simulation/time_step.hpp"
#include "tests/support/history_of.hpp"

namespace capstan {
namespace {

std::string red_cell(const std::string& kt, const std::string& knobs) {
  return R"({"fluid": "quasisteady", "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": 0.4, "V": 4, "until": {"kt": )" +
         kt + R"(}, "outputs": {"shapes_every": 0}, "fidelity": {"preset": "fast")" + knobs + "}}";
}

/// D_xy after each step of a run on the composite or the uniform grid.
std::vector<double> deformations(bool is_uniform) {
  const Case c = testing::parsed_case(red_cell("2", R"(, "kdt": 0.05)"));
  const Icosphere sphere = make_icosphere(3);
  Points x = initial_positions(c, sphere), forces, u, before;
  const Membrane membrane(c, sphere.mesh, x, Orbits::of(x));
  QuasisteadyFlow<float> flow(sphere.mesh, Orbits::of(x), {.dx = 0.2, .V = c.V, .is_uniform = is_uniform});
  AdamsBashforth2 stepper(c.fidelity.kdt);
  std::vector<double> D;
  for (int step = 0; step < 40; ++step) {
    membrane.forces(x, forces);
    EXPECT_TRUE(flow.solve(step * c.fidelity.kdt, x, forces, u).converged);
    stepper.advance({}, step * c.fidelity.kdt, u, x);
    D.push_back(deformation(inertia_ellipse(x, sphere.mesh.faces)).D_xy);
  }
  return D;
}

TEST(CompositeRun, DeformsAsOnTheUniformGridToFiveParts) {
  const auto composite = deformations(false), uniform = deformations(true);
  for (std::size_t i = 0; i < uniform.size(); ++i)
    EXPECT_NEAR(composite[i], uniform[i], 5e-4) << "step " << i;
}

TEST(CompositeRun, OfAQuarterIsThatOfTheWhole) {
  const History quarter = testing::history_of(red_cell("4", R"(, "tolerance": 1e-4)"));
  const History whole = testing::history_of(red_cell("4", R"(, "tolerance": 1e-4, "symmetry": "none")"));
  ASSERT_EQ(quarter.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    EXPECT_NEAR(quarter[i]["D_xy"], whole[i]["D_xy"], 2e-4) << whole[i]["kt"];
}

TEST(CompositeRun, HasTheSameHistoryToTheLastBitOnOneThreadAndOnTwo) {
  omp_set_num_threads(1);
  const History alone = testing::history_of(red_cell("1", R"(, "symmetry": "none")"));
  omp_set_num_threads(2);
  const History together = testing::history_of(red_cell("1", R"(, "symmetry": "none")"));
  omp_set_num_threads(1);
  EXPECT_EQ(alone, together);
}

// The first step, Euler's, changes it most. The flow then returns it.
TEST(CompositeRun, KeepsTheVolumeToATenthOfAPercent) {
  for (const char* keys : {R"("Ca": 0.3, "V": 0.2)", R"("Ca": 1, "V": 5, "law": "skalak", "C": 1)"}) {
    const History history = testing::history_of("{" + std::string(keys) +
                                                R"(, "fluid": "quasisteady", "until": {"kt": 4},
      "outputs": {"shapes_every": 0, "history_every": 0.05}, "fidelity": "fast"})");
    for (const auto& record : history)
      EXPECT_NEAR(record["volume"] / history.front()["volume"], 1, 1e-3) << keys;
    EXPECT_NEAR(history.back()["volume"] / history.front()["volume"], 1, 1e-4) << keys;
  }
}

// In a box this large, convection of momentum exceeds viscosity far from the capsule.
TEST(CompositeRun, StaysStableInALargeBoxAndDeformsAsInASmallerOne) {
  const auto in_box = [](const std::string& box) {
    return testing::history_of(R"({"shape": "oblate", "aspect": 0.5, "Ca": 0.1, "until": {"kt": 3},
      "fidelity": {"preset": "fast", "kdt": 0.02, "box": )" +
                               box + "}}")
        .back()["D_xy"];
  };
  EXPECT_NEAR(in_box("51.2"), in_box("12.8"), 2e-3);
}

}  // namespace
}  // namespace capstan
