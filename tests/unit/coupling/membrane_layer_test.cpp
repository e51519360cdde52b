#include "solver/coupling/membrane_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "solver/coupling/sharpening.hpp"
#include "tests/support/source_directory.hpp"

namespace capstan {
namespace {

double spline_transform(double k) { return k == 0 ? 1 : std::pow(std::sin(k / 2) / (k / 2), 4); }
double sharp_transform(const Vec3& k) {
  return spline_transform(k[0]) * spline_transform(k[1]) * spline_transform(k[2]) *
         sharpening_symbol(k[0], k[1], k[2]);
}
const Vec3 kNormals[] = {Vec3(1, 0, 0), Vec3(1, 1, 0).normalized(), Vec3(1, 1, 1).normalized(),
                         Vec3(1, 2, 3).normalized()};

TEST(Sharpening, ItsSymbolInvertsTheSplineToSixthOrderAlongAnAxis) {
  const auto error = [](double k) { return std::abs(spline_transform(k) * sharpening_symbol(k, 0, 0) - 1); };
  EXPECT_LT(error(0.1), 1e-8);
  EXPECT_NEAR(error(0.4) / error(0.2), 64, 6);
}

TEST(Sharpening, ItsSymbolInvertsTheSplineToFourthOrderInEveryDirection) {
  for (const Vec3& n : kNormals) {
    const auto error = [&](double k) { return std::abs(sharp_transform(k * n) - 1); };
    EXPECT_LT(error(0.2), 2 * std::pow(0.2, 4)) << n.transpose();
  }
}

// The numbers of the table in the study are those of the code.
TEST(MembraneLayer, ItsConstantsAreTheResultsOfTheStudy) {
  std::ifstream results(source_directory() / "studies/flat_membrane/results.md");
  const double psi = 0.1279 / layer_corrections(1).kink;
  EXPECT_NEAR(psi, 0.483, 5e-4);  // the mean over 400 random directions
  int rows = 0;
  for (std::string line; std::getline(results, line);) {
    std::ranges::replace(line, '|', ' ');
    std::istringstream cells(line);
    double V, viscosity, fluidity, slip, C, tension;
    if (!(cells >> V >> viscosity >> fluidity >> slip >> C >> tension)) continue;
    ++rows;
    const LayerCorrections corrections = layer_corrections(V);
    EXPECT_NEAR(corrections.slip, slip, 1e-12) << "V = " << V;
    EXPECT_NEAR(corrections.tension, tension, 1e-12) << "V = " << V;
    EXPECT_NEAR(corrections.kink * psi, std::max(0., C), 1e-12) << "V = " << V;
    if (V == 1) continue;
    const ViscosityProfile R = layer_viscosity(V);
    EXPECT_NEAR(R(-0.5, 0), V + 2 / 1.3 * viscosity * (V - 1), 1e-9) << "V = " << V;
    EXPECT_NEAR(1 / R(1, 0), 1 + fluidity * (1 - 1 / V), 1e-9) << "V = " << V;
  }
  EXPECT_EQ(rows, 10);
}

TEST(MembraneLayer, AtEqualViscositiesOnlyTheKinkIsLeft) {
  EXPECT_EQ(layer_corrections(1).slip, 0);
  EXPECT_EQ(layer_corrections(1).tension, 0);
  EXPECT_GT(layer_corrections(1).kink, 0);
  for (double z = -3; z < 3; z += 0.1) EXPECT_EQ(layer_viscosity(1)(z, 0.3), 1);
}

TEST(MembraneLayer, TheKinkTermNeverTakesPowerFromTheFluid) {
  for (double V = 0.01; V < 200; V *= 1.3) EXPECT_GE(layer_corrections(V).kink, 0) << "V = " << V;
}

TEST(MembraneLayer, LayerOfAThinInnerFluidIsTheMirrorImage) {
  for (double V : {1.2, 4.0, 30.0}) {
    EXPECT_NEAR(layer_corrections(V).slip, -layer_corrections(1 / V).slip, 1e-12);
    EXPECT_NEAR(layer_corrections(V).tension, -layer_corrections(1 / V).tension, 1e-12);
    EXPECT_NEAR(layer_corrections(V).kink, layer_corrections(1 / V).kink / V, 1e-12);
    for (double z = -3; z < 3; z += 0.1)
      EXPECT_NEAR(layer_viscosity(V)(z, 0.3), V * layer_viscosity(1 / V)(-z, -0.3), 1e-12);
  }
}

// To the last bit: rows of ambient fluid are told by a ratio of 1.
TEST(MembraneLayer, ViscosityIsThatOfEitherFluidBeyondItsReach) {
  for (double V : {0.05, 0.18, 4.0, 100.0}) {
    EXPECT_EQ(layer_viscosity(V)(-kLayerReach, 0.3), V);
    EXPECT_EQ(layer_viscosity(V)(kLayerReach, 0.3), 1);
  }
}

}  // namespace
}  // namespace capstan
