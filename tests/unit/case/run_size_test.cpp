#include "solver/case/run_size.hpp"

#include <gtest/gtest.h>

#include "tests/support/parsed_case.hpp"

namespace capstan {
namespace {

double size(const std::string& keys) { return run_size(testing::parsed_case("{\"Ca\": 0.1" + keys + "}")); }

/// Sums of the files that real runs and their companions left, with one checkpoint each.
TEST(RunSize, IsThatOfRealRuns) {
  EXPECT_NEAR(size(R"(, "fluid": "stokes", "until": {"kt": 2}, "fidelity": "fast")"), 334e3, 40e3);
  EXPECT_NEAR(size(R"(, "fluid": "stokes", "until": {"kt": 2}, "fidelity": {"nodes": 2562})"), 1130e3, 100e3);
  EXPECT_NEAR(size(R"(, "fluid": "quasisteady", "until": {"kt": 0.2}, "fidelity": "standard",
                      "outputs": {"shapes_every": 0.1})"),
              4.4e6, 1e6);
  EXPECT_NEAR(size(R"(, "V": 4, "shape": "biconcave", "fluid": "quasisteady", "until": {"kt": 0.2},
                      "fidelity": "standard", "outputs": {"shapes_every": 0.1})"),
              5.0e6, 1e6);
  EXPECT_NEAR(size(R"(, "fluid": "transient", "Re": 1, "until": {"kt": 0.3}, "fidelity": "fast",
                      "outputs": {"shapes_every": 0.1})"),
              50.1e6, 5e6);
  EXPECT_NEAR(size(R"(, "fluid": "quasisteady", "fidelity": {"nodes": 642, "scheme": "paper", "dx": 0.2},
                      "until": {"kt": 0.1}, "outputs": {"shapes_every": 0.05})"),
              43.9e6, 8e6);
}

TEST(RunSize, GrowsWithTheShapesThatAreAskedFor) {
  const double without = size(R"(, "outputs": {"shapes_every": 0})");
  const double with = size(R"(, "outputs": {"shapes_every": 0.1})");
  EXPECT_GT(with, without + 300 * 2562 * 72);
}

/// Peaks of real runs.
TEST(RunMemory, IsThatOfRealRuns) {
  const auto megabytes = [](const std::string& keys) {
    return run_memory(testing::parsed_case("{\"Ca\": 0.1, \"V\": 4, " + keys + "}")) / 1e6;
  };
  EXPECT_NEAR(megabytes(R"("fluid": "stokes", "fidelity": "fast")"), 19, 4);
  EXPECT_NEAR(megabytes(R"("fluid": "stokes", "fidelity": "fine")"), 36, 6);
  EXPECT_NEAR(megabytes(R"("fluid": "unsteady", "fidelity": "fast")"), 30, 5);
  EXPECT_NEAR(megabytes(R"("fluid": "quasisteady", "fidelity": "standard")"), 38, 7);
  EXPECT_NEAR(megabytes(R"("fluid": "quasisteady", "fidelity": {"preset": "standard", "symmetry": "none"})"),
              78, 12);
  EXPECT_NEAR(
      megabytes(R"("fluid": "quasisteady", "fidelity": {"preset": "standard", "precision": "double"})"), 47,
      9);
  EXPECT_NEAR(megabytes(R"("fluid": "transient", "fidelity": "fast")"), 93, 10);
  EXPECT_NEAR(megabytes(R"("fluid": "transient", "fidelity": "standard")"), 538, 50);
  EXPECT_NEAR(megabytes(R"("fluid": "quasisteady", "fidelity": {"preset": "paper", "dx": 0.2})"), 182, 20);
}

}  // namespace
}  // namespace capstan
