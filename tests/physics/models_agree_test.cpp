// The quasisteady and the transient model agree if inertia is small.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/history_of.hpp"

namespace capstan {
namespace {

/// A run of a sphere to kt = 1 on a coarse grid.
History sphere(const std::string& V, const std::string& Re, const std::string& flow) {
  return testing::history_of(R"({"Ca": 0.1, "V": )" + V + R"(, "Re": )" + Re +
                             R"(, "until": {"kt": 1}, "outputs": {"history_every": 0.1}, )" + flow + "}");
}

const std::string kQuasisteady = R"("fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.02})";
const std::string kTransient = R"("fluid": "transient", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162})";

/// Largest difference of D_xy from kt = 0.2 on, over the final D_xy.
double difference(const std::string& V, const std::string& Re) {
  const History a = sphere(V, Re, kQuasisteady), b = sphere(V, Re, kTransient);
  double worst = 0;
  for (const Record& record : a)
    if (record["kt"] > 0.15)
      worst = std::max(worst, std::abs(record["D_xy"] - testing::at(b, record["kt"])["D_xy"]));
  return worst / a.back()["D_xy"];
}

// Measured: 0.013, and 0.005 at a quarter of Re.
TEST(ModelsAgree, DeformationsDifferByLessThanTwoPercentAtReynoldsNumberOneTwentieth) {
  EXPECT_LT(difference("1", "0.05"), 0.02);
}

TEST(ModelsAgree, DifferenceOfTheModelsShrinksWithInertia) {
  EXPECT_LT(difference("1", "0.0125"), 0.5 * difference("1", "0.05"));
}

// Measured: 0.007.
TEST(ModelsAgree, DeformationsDifferByLessThanTwoPercentWithAViscosityRatio) {
  EXPECT_LT(difference("4", "0.05"), 0.02);
}

/// D_xy at kt = 1 in the transient model, in single or double precision.
double deformation(const std::string& precision) {
  return sphere("4", "0.05",
                R"("fluid": "transient",
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "precision": ")" +
                    precision + "\"}")
      .back()["D_xy"];
}

// Measured: 3e-8.
TEST(ModelsAgree, SinglePrecisionChangesTheDeformationByLessThanOneInAMillion) {
  EXPECT_NEAR(deformation("float"), deformation("double"), 1e-6 * deformation("double"));
}

}  // namespace
}  // namespace capstan
