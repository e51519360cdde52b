// Stiff capsules, which need small time steps, run at the defaults. Thin capsules whose membrane folds stop
// with a message that names a remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/simulation/simulation.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::parsed_case;

struct FinishedRun {
  Outcome outcome;
  RunStatistics statistics;
};

FinishedRun run(const std::string& text) {
  testing::MemoryOutput output;
  Simulation simulation(parsed_case(text));
  const Outcome outcome = simulation.run(output);
  return {outcome, simulation.statistics()};
}

TEST(StiffCapsules, RunAtTheDefaultsOfALattice) {
  for (const char* keys :
       {R"("E_b": 1, "Ca": 0.1, "until": {"kt": 0.25})",
        R"("shape": "prolate", "aspect": 4, "law": "skalak", "C": 10, "Ca": 0.1, "until": {"kt": 0.6})",
        R"("shape": "prolate", "aspect": 5, "law": "skalak", "C": 10, "Ca": 0.02, "until": {"kt": 0.12})"}) {
    const FinishedRun done =
        run(std::string(R"({"fluid": "quasisteady", "fidelity": "fast", )") + keys + "}");
    EXPECT_EQ(done.outcome.stop, Stop::reached_end) << keys << done.outcome.message;
    EXPECT_LT(done.statistics.volume_drift, 0.01) << keys;
  }
}

// Spherical harmonics: D_xy = 0.4310 at kt = 5. With a step of 0.067 it came out as 0.416.
TEST(HardeningSpheres, DeformAtTheDefaultsOfALatticeAsBySphericalHarmonics) {
  testing::MemoryOutput output;
  Simulation simulation(parsed_case(R"({"law": "skalak", "C": 1, "Ca": 0.3, "fluid": "quasisteady",
    "until": {"kt": 5}, "fidelity": "fast"})"));
  simulation.run(output);
  EXPECT_NEAR(simulation.history().back()["D_xy"], 0.4310, 0.015 * 0.4310);
}

const std::string kThin =
    R"("shape": "oblate", "aspect": 0.59, "law": "skalak", "Ca": 1.03, "V": 0.153, "fluid": "stokes",
                             "until": {"kt": 3}, "fidelity": {"nodes": 162})";

TEST(ThinCapsules, WhoseMembraneFoldsStopSoonWithARemedy) {
  const FinishedRun stopped = run(R"({"C": 0, )" + kThin + "}");
  EXPECT_EQ(stopped.outcome.stop, Stop::diverged);
  EXPECT_THAT(stopped.outcome.message,
              AllOf(HasSubstr("at kt = "), HasSubstr("raise E_b to 0.005"), HasSubstr("raise C")));
  EXPECT_LT(stopped.statistics.flow_iterations, 10000);
}

TEST(ThinCapsules, RunToTheEndWithTheRemedy) {
  EXPECT_EQ(run(R"({"C": 0.5, "E_b": 0.005, )" + kThin + "}").outcome.stop, Stop::reached_end);
}

TEST(QuasisteadyFlow, WithMuchInertiaStopsAndNamesTheUnsteadyModel) {
  const FinishedRun stopped = run(R"({"Ca": 0.1, "Re": 10, "fluid": "quasisteady", "until": {"kt": 1},
                              "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162}})");
  EXPECT_EQ(stopped.outcome.stop, Stop::diverged);
  EXPECT_THAT(stopped.outcome.message, HasSubstr("take the fluid unsteady"));
}

TEST(UnsteadyFlow, WithMuchInertiaRunsToTheEnd) {
  const FinishedRun finished = run(R"({"Ca": 0.1, "Re": 10, "fluid": "unsteady", "until": {"kt": 1},
                              "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162}})");
  EXPECT_EQ(finished.outcome.stop, Stop::reached_end) << finished.outcome.message;
}

}  // namespace
}  // namespace capstan
