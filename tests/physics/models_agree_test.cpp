// The quasisteady and the transient model agree if inertia is small, the unsteady and the transient one in
// any case.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/history_of.hpp"

namespace capstan {
namespace {

/// A run of a sphere to kt = 1 on a coarse grid.
History sphere(const std::string& V, const std::string& Re, const std::string& flow) {
  return testing::history_of(R"({"Ca": 0.1, "V": )" + V + R"(, "Re": )" + Re +
                             R"(, "until": {"kt": 1}, "outputs": {"history_every": 0.1}, )" + flow + "}");
}

const std::string kQuasisteady =
    R"("fluid": "quasisteady", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.02})";
const std::string kUnsteady =
    R"("fluid": "unsteady", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.02})";
const std::string kTransient = R"("fluid": "transient", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162})";
/// Quasi-steady, with the coupling of the transient lattice.
const std::string kPaper =
    R"("fluid": "quasisteady", "fidelity": {"preset": "paper", "dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.02})";

/// Largest difference of D_xy from kt = 0.2 on, over the final D_xy.
double difference(const std::string& V, const std::string& Re) {
  const History a = sphere(V, Re, kPaper), b = sphere(V, Re, kTransient);
  double worst = 0;
  for (const Record& record : a)
    if (record["kt"] > 0.15)
      worst = std::max(worst, std::abs(record["D_xy"] - testing::at(b, record["kt"])["D_xy"]));
  return worst / a.back()["D_xy"];
}

TEST(ModelsAgree, DeformationsDifferByLessThanTwoPercentAtReynoldsNumberOneTwentieth) {
  EXPECT_LT(difference("1", "0.05"), 0.02);
}

TEST(ModelsAgree, DifferenceOfTheModelsShrinksWithInertia) {
  EXPECT_LT(difference("1", "0.0125"), 0.5 * difference("1", "0.05"));
}

TEST(ModelsAgree, DeformationsDifferByLessThanTwoPercentWithAViscosityRatio) {
  EXPECT_LT(difference("4", "0.05"), 0.02);
}

/// D_xy (cos 2 theta, sin 2 theta)
Eigen::Vector2d shape(const Record& record) {
  return record["D_xy"] * Eigen::Vector2d(std::cos(2 * record["theta"]), std::sin(2 * record["theta"]));
}

/// How one flow model differs from another at the times of the records.
std::vector<Eigen::Vector2d> effect(const std::string& Re, const std::string& with,
                                    const std::string& without) {
  const History a = sphere("1", Re, with), b = sphere("1", Re, without);
  std::vector<Eigen::Vector2d> differences;
  for (const Record& record : a) differences.push_back(shape(record) - shape(testing::at(b, record["kt"])));
  return differences;
}

// The models that are compared have different couplings of membrane and fluid. So the effect of the time
// derivative is compared, between models of equal coupling. Measured: apart by 0.32 and 0.30 of the effect at
// dx = 0.4.
TEST(ModelsAgree, TheTimeDerivativeHasTheSameEffectInUnsteadyAndInTransientFlow) {
  for (const char* Re : {"0.1", "0.25"}) {
    const auto unsteady = effect(Re, kUnsteady, kQuasisteady), transient = effect(Re, kTransient, kPaper);
    double largest = 0, apart = 0;
    for (std::size_t n = 0; n < unsteady.size(); ++n) {
      largest = std::max(largest, transient[n].norm());
      apart = std::max(apart, (unsteady[n] - transient[n]).norm());
    }
    EXPECT_LT(apart, largest / 3) << "Re = " << Re << ", effect " << largest;
  }
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
