#include "runner/worker/cost_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "solver/case/run_cost.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using capstan::testing::parsed_case;

Case stokes_case(double Ca) {
  return parsed_case(R"({"fluid": "stokes", "fidelity": {"nodes": 42}, "Ca": )" + std::to_string(Ca) + "}");
}

std::vector<Case> stokes_cases(int count) {
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) cases.push_back(stokes_case(0.01 * (i + 1)));
  return cases;
}

TEST(CostModel, MeasuredCaseTakesItsMeasuredTime) {
  const std::vector<Case> cases = stokes_cases(3);
  const std::vector<double> seconds =
      estimated_seconds(cases, [](const Case& c, double) { return 100 * c.Ca; });
  ASSERT_EQ(seconds.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_DOUBLE_EQ(seconds[i], 100 * cases[i].Ca);
}

TEST(CostModel, OtherCasesScaleWithTheNearestMeasuredOne) {
  const std::vector<Case> cases = stokes_cases(100);
  std::vector<double> measured;
  const std::vector<double> seconds = estimated_seconds(cases, [&](const Case& c, double) {
    measured.push_back(c.Ca);
    return c.Ca * run_cost(c);
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double nearest = measured.front();
    for (double Ca : measured)
      if (std::abs(std::log(Ca / cases[i].Ca)) < std::abs(std::log(nearest / cases[i].Ca))) nearest = Ca;
    EXPECT_DOUBLE_EQ(seconds[i], nearest * case_cost(cases[i])) << "Ca = " << cases[i].Ca;
  }
}

TEST(CostModel, MeasurementsAreFewAndShareTwoSeconds) {
  int measurements = 0;
  double seconds = 0;
  estimated_seconds(stokes_cases(100), [&](const Case&, double limit) {
    ++measurements;
    seconds += limit;
    return 1.;
  });
  EXPECT_EQ(measurements, 8);
  EXPECT_DOUBLE_EQ(seconds, 2);
}

TEST(CostModel, EveryKindOfCaseIsMeasured) {
  std::vector<Case> cases = stokes_cases(2);
  cases.push_back(parsed_case(R"({"fluid": "stokes", "fidelity": {"nodes": 162}, "Ca": 0.1})"));
  cases.push_back(parsed_case(R"({"fluid": "stokes", "fidelity": {"nodes": 42}, "Ca": 0.1, "V": 4})"));
  cases.push_back(parsed_case(R"({"fluid": "quasisteady", "fidelity": "fast", "Ca": 0.1})"));
  std::set<std::tuple<Fluid, int, bool>> kinds;
  estimated_seconds(cases, [&](const Case& c, double) {
    kinds.emplace(c.fluid, c.fidelity.nodes, c.has_viscosity_ratio());
    return 1.;
  });
  EXPECT_EQ(kinds.size(), 4u);
}

TEST(WallTime, OfOneCoreIsTheSumOfAllCases) { EXPECT_EQ(wall_seconds({1, 2, 3}, 1), 6); }

TEST(WallTime, IsAtLeastThatOfTheLongestCase) { EXPECT_EQ(wall_seconds({1, 2, 30}, 100), 30); }

TEST(WallTime, OfSeveralCoresIncludesHalfOfTheLongestCase) {
  EXPECT_EQ(wall_seconds(std::vector<double>(10, 4), 2), 20 + 2);
}

TEST(CostModel, ShortRunOfACaseYieldsAPositiveFiniteTime) {
  const double seconds = time_by_short_run(stokes_case(0.1), 0);
  EXPECT_GT(seconds, 0);
  EXPECT_TRUE(std::isfinite(seconds));
}

}  // namespace
}  // namespace capstan
