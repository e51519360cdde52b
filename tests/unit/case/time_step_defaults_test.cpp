#include "solver/case/time_step_defaults.hpp"

#include <gtest/gtest.h>

#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

using testing::parsed_case;

Case on_lattice(const std::string& keys, const std::string& fidelity = R"("fast")") {
  return parsed_case("{" + keys + R"(, "fluid": "quasisteady", "fidelity": )" + fidelity + "}");
}

TEST(TimeStepDefaults, StiffMembranesOnALatticeTakeTheStepperThatMeasuresTheStiffness) {
  for (const char* keys :
       {R"("Ca": 0.1, "E_b": 1)", R"("Ca": 0.1, "law": "skalak", "C": 10, "shape": "prolate", "aspect": 4)",
        R"("Ca": 0.02, "law": "skalak", "C": 10, "shape": "prolate", "aspect": 5)",
        R"("Ca": 0.001, "law": "skalak", "C": 1000)",
        R"("Ca": 0.1, "E_b": 0.1, "shape": "prolate", "aspect": 5)",
        R"("Ca": 0.05, "E_b": 0.1, "shape": "oblate", "aspect": 0.2)"})
    for (const char* fidelity : {R"("fast")", R"({"dx": 0.1, "nodes": 2562})"}) {
      const Case c = on_lattice(keys, fidelity);
      EXPECT_EQ(c.fidelity.stepper, Stepper::runge_kutta_chebyshev) << keys << fidelity;
      EXPECT_EQ(c.fidelity.kdt, 0) << keys << fidelity;
    }
}

TEST(TimeStepDefaults, SoftMembranesOnALatticeTakeAb2WithTheStepOfTheGrid) {
  const std::string red_cell = R"("shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015)";
  for (const Case& c : {on_lattice(R"("Ca": 1)"), on_lattice(red_cell + R"(, "Ca": 2, "V": 4)")}) {
    EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth) << to_json(c);
    EXPECT_DOUBLE_EQ(c.fidelity.kdt, 0.05) << to_json(c);
  }
}

constexpr const char* kAb2 = R"({"preset": "fast", "stepper": "ab2"})";

TEST(TimeStepDefaults, StifferOnesWithAb2TakeHalfOfTheStableStep) {
  const std::string red_cell = R"("shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015)";
  for (const std::string& keys : {std::string(R"("Ca": 0.1)"), red_cell + R"(, "Ca": 0.4, "V": 10)"}) {
    const Case c = on_lattice(keys, kAb2);
    EXPECT_NEAR(c.fidelity.kdt * fastest_decay(c), 0.5, 1e-6) << to_json(c);
  }
}

// At Ca = 2, V = 10 elasticity alone would give a decay rate of 2.
TEST(TimeStepDefaults, AContrastOfViscositiesLimitsTheStepHoweverSoftTheMembraneIs) {
  const std::string soft = R"("shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": 2)";
  EXPECT_GT(fastest_decay(on_lattice(soft + R"(, "V": 10)")), 10);
  EXPECT_LT(fastest_decay(on_lattice(soft + R"(, "V": 1)")), 5);
}

// With steps of 0.067 the first comes out with D_xy = 0.416 instead of 0.434.
TEST(TimeStepDefaults, RoundMembranesThatHardenTakeShorterStepsWithAb2) {
  for (const char* keys : {R"("Ca": 0.3, "law": "skalak", "C": 1)", R"("Ca": 0.2, "law": "skalak", "C": 0.5)",
                           R"("Ca": 0.3, "law": "skalak", "C": 1, "shape": "oblate", "aspect": 0.9)"}) {
    const Case c = on_lattice(keys, kAb2);
    EXPECT_NEAR(c.fidelity.kdt * fastest_decay(c), 0.35, 1e-6) << to_json(c);
  }
}

TEST(TimeStepDefaults, DrawnOutMembranesThatHardenTakeTheStepperThatMeasuresTheStiffness) {
  const std::string red_cell = R"("shape": "biconcave", "law": "skalak", "C": 1, "E_b": 0.015)";
  for (const char* keys : {R"(, "Ca": 4, "V": 1)", R"(, "Ca": 1, "V": 0.1)"})
    EXPECT_EQ(on_lattice(red_cell + keys).fidelity.stepper, Stepper::runge_kutta_chebyshev) << keys;
  EXPECT_EQ(on_lattice(red_cell + R"(, "Ca": 2, "V": 1)").fidelity.stepper, Stepper::adams_bashforth);
  const Case unsteady =
      parsed_case("{" + red_cell + R"(, "Ca": 4, "V": 1, "fluid": "unsteady", "fidelity": "fast"})");
  EXPECT_NEAR(unsteady.fidelity.kdt, 0.02, 1e-9);
}

TEST(TimeStepDefaults, ThePapersSchemeKeepsThePapersSteps) {
  const Case c = on_lattice(R"("Ca": 0.0125)", R"("paper")");
  EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth);
  EXPECT_DOUBLE_EQ(c.fidelity.kdt, 0.005);
}

// Measured to kt = 4: 3.2 and 1.6 times less processor time than with ab2.
TEST(TimeStepDefaults, SmallCapillaryNumbersOnALatticeTakeTheStepperThatCostsLess) {
  EXPECT_EQ(on_lattice(R"("Ca": 0.0125)").fidelity.stepper, Stepper::runge_kutta_chebyshev);
  EXPECT_EQ(on_lattice(R"("Ca": 0.05)", R"("standard")").fidelity.stepper, Stepper::runge_kutta_chebyshev);
}

TEST(TimeStepDefaults, AWishForAb2GetsAStepThatIsStable) {
  for (const char* fidelity :
       {R"({"preset": "fast", "stepper": "ab2"})", R"({"scheme": "paper", "stepper": "ab2"})"}) {
    const Case c = on_lattice(R"("Ca": 0.1, "E_b": 1)", fidelity);
    EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth);
    EXPECT_LT(c.fidelity.kdt * fastest_decay(c), 0.7);
  }
  const Case stokes =
      parsed_case(R"({"Ca": 0.1, "E_b": 1, "fluid": "stokes", "fidelity": {"stepper": "ab2"}})");
  EXPECT_LT(stokes.fidelity.kdt * fastest_decay(stokes), 0.7);
}

TEST(TimeStepDefaults, AStepThatIsAskedForIsTaken) {
  const Case c = on_lattice(R"("Ca": 0.1, "E_b": 1)", R"({"preset": "fast", "kdt": 0.03})");
  EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth);
  EXPECT_EQ(c.fidelity.kdt, 0.03);
}

// Measured by power iteration on the flows themselves; the estimate must not be far below.
TEST(FastestDecay, IsThatOfTheMeasuredRates) {
  const auto expect_rate = [](const Case& c, double measured) {
    EXPECT_GT(fastest_decay(c), 0.75 * measured) << to_json(c);
    EXPECT_LT(fastest_decay(c), 2 * measured) << to_json(c);
  };
  expect_rate(on_lattice(R"("Ca": 0.1)"), 14.4);
  expect_rate(on_lattice(R"("Ca": 0.1, "V": 5)"), 7);
  expect_rate(on_lattice(R"("Ca": 0.1, "V": 0.2)"), 24.3);
  expect_rate(on_lattice(R"("Ca": 0.1, "E_b": 1)"), 1600);
  expect_rate(on_lattice(R"("Ca": 0.1, "E_b": 0.1)", R"({"dx": 0.1, "nodes": 2562})"), 1370);
  expect_rate(on_lattice(R"("Ca": 0.1, "law": "skalak", "C": 10)"), 123);
  expect_rate(on_lattice(R"("Ca": 0.1, "law": "skalak", "C": 10, "shape": "prolate", "aspect": 4)"), 767);
  expect_rate(on_lattice(R"("Ca": 0.1, "E_b": 0.1, "shape": "oblate", "aspect": 0.1)"), 1410);
  const std::string stokes = R"(, "Ca": 0.1, "fluid": "stokes", "fidelity": "fast"})";
  expect_rate(parsed_case(R"({"E_b": 0.1)" + stokes), 834);
  expect_rate(parsed_case(R"({"law": "skalak", "C": 10)" + stokes), 265);
  expect_rate(parsed_case(R"({"E_b": 0.1, "V": 5)" + stokes), 280);
}

}  // namespace
}  // namespace capstan
