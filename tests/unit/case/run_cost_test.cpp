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
  for (const char* fluid : {"quasisteady", "transient", "stokes"}) {
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

}  // namespace
}  // namespace capstan
