#include "solver/case/run_cost.hpp"

#include <gtest/gtest.h>

#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

double cost(const std::string& keys, double Ca = 0.25) {
  return run_cost(testing::parsed_case(R"({"shape": "biconcave", "E_b": 0.015, "Ca": )" + std::to_string(Ca) +
                                       keys + "}"));
}

TEST(RunCost, GrowsWithTheLengthOfTheRun) {
  for (const char* fluid : {"quasisteady", "unsteady", "transient", "stokes"}) {
    const std::string of_fluid = std::string(R"(, "fluid": ")") + fluid + '"';
    EXPECT_NEAR(cost(of_fluid + R"(, "until": {"kt": 60})") / cost(of_fluid + R"(, "until": {"kt": 30})"), 2,
                1e-12);
  }
}

TEST(RunCost, IsHigherWithViscosityContrastAFinerGridAndWithoutSymmetry) {
  EXPECT_LT(cost(""), cost(R"(, "V": 4)"));
  for (const char* fluid : {"quasisteady", "stokes"}) {
    const auto with_fidelity = [fluid](const std::string& fidelity) {
      return cost(std::string(R"(, "fluid": ")") + fluid + R"(", "fidelity": )" + fidelity);
    };
    EXPECT_LT(with_fidelity(R"("fast")"), with_fidelity(R"("standard")"));
    EXPECT_LT(with_fidelity(R"("standard")"), with_fidelity(R"({"preset": "standard", "symmetry": "none"})"));
  }
}

TEST(RunCost, OfTheShortestAndTheLongestRunsIsANumberThatCanBeSummed) {
  Case c = testing::parsed_case(R"({"Ca": 0.25, "fluid": "transient"})");
  c.until.kt = 1e-300;
  EXPECT_GE(run_cost(c), 1e-4);
  c.until.kt = 30;
  c.Re = 1e-310;
  EXPECT_LE(run_cost(c), 1e10);
}

TEST(RunCost, OfBoundaryIntegralsGrowsWithTheMembranesStiffness) {
  EXPECT_LT(cost(R"(, "fluid": "stokes")"), cost(R"(, "fluid": "stokes")", 0.05));
}

double cost_of(const std::string& shape, const std::string& fidelity, const char* fluid) {
  return run_cost(testing::parsed_case(R"({"Ca": 0.1, )" + shape + R"(, "fluid": ")" + fluid +
                                       R"(", "fidelity": )" + fidelity + "}"));
}
const std::string kSphere = R"("shape": "sphere")", kNeedle = R"("shape": "prolate", "aspect": 4)";

/// The bands hold measured ratios of processor time.
TEST(RunCost, KnowsDrawnOutCapsules) {
  const auto ratio = [](const char* fidelity, const char* fluid) {
    return cost_of(kNeedle, fidelity, fluid) / cost_of(kSphere, fidelity, fluid);
  };
  EXPECT_NEAR(ratio(R"({"nodes": 642})", "stokes"), 4.2, 1);
  EXPECT_NEAR(ratio(R"({"nodes": 2562})", "stokes"), 3.9, 1.5);
  EXPECT_NEAR(ratio(R"({"preset": "standard", "stepper": "ab2", "kdt": 0.02})", "quasisteady"), 1.55, 0.3);
}

TEST(RunCost, KnowsCoarseAndFineMeshes) {
  const auto cost_with = [](int nodes) {
    return cost_of(kSphere, "{\"nodes\": " + std::to_string(nodes) + "}", "stokes");
  };
  EXPECT_NEAR(cost_with(642) / cost_with(162), 7, 3);
  EXPECT_NEAR(cost_with(2562) / cost_with(642), 10, 4);
  EXPECT_NEAR(cost_with(10242) / cost_with(2562), 20, 8);
}

}  // namespace
}  // namespace capstan
