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

TEST(TimeStepDefaults, ThePapersCasesKeepTheirStepsAndAb2) {
  const auto expect_kdt = [](const Case& c, double kdt) {
    EXPECT_EQ(c.fidelity.stepper, Stepper::adams_bashforth) << to_json(c);
    EXPECT_DOUBLE_EQ(c.fidelity.kdt, kdt) << to_json(c);
  };
  expect_kdt(on_lattice(R"("Ca": 0.0125)"), 0.005);
  expect_kdt(on_lattice(R"("Ca": 0.05)"), 0.02);
  expect_kdt(on_lattice(R"("Ca": 0.2)"), 0.08);
  expect_kdt(on_lattice(R"("Ca": 0.05)", R"("standard")"), 0.01);
  const std::string red_cell = R"("shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015)";
  for (const char* V : {"1", "4", "10"}) {
    expect_kdt(on_lattice(red_cell + R"(, "Ca": 0.05, "V": )" + V), 0.02);
    expect_kdt(on_lattice(red_cell + R"(, "Ca": 0.25, "V": )" + V), 0.08);
  }
  expect_kdt(on_lattice(red_cell + R"(, "Ca": 0.25, "V": 4)", R"("standard")"), 0.04);
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
  expect_rate(on_lattice(R"("Ca": 0.05)"), 5.5);
  expect_rate(on_lattice(R"("Ca": 0.1, "E_b": 1)"), 153);
  expect_rate(on_lattice(R"("Ca": 0.1, "E_b": 0.1)", R"({"dx": 0.1, "nodes": 2562})"), 121);
  expect_rate(on_lattice(R"("Ca": 0.1, "law": "skalak", "C": 10)"), 22);
  expect_rate(on_lattice(R"("Ca": 0.1, "law": "skalak", "C": 10, "shape": "prolate", "aspect": 5)"), 162);
  const std::string stokes = R"(, "Ca": 0.1, "fluid": "stokes", "fidelity": "fast"})";
  expect_rate(parsed_case(R"({"E_b": 0.1)" + stokes), 834);
  expect_rate(parsed_case(R"({"law": "skalak", "C": 10)" + stokes), 265);
  expect_rate(parsed_case(R"({"E_b": 0.1, "V": 5)" + stokes), 280);
}

}  // namespace
}  // namespace capstan
