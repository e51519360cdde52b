// The constants of the second-order coupling, by a second route.
#include "solver/coupling/membrane_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/coupling/sharpening.hpp"

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

// By Fourier transforms: the kink of planes of cells is h^2/(2 - 2 cos(k h)) - 1/12 where the sharp one is
// 1/k^2. The code adds the planes.
TEST(MembraneLayer, KinkIsThatOfTheGreensFunctionOfPlanesOfCells) {
  const struct {
    Vec3 normal;
    double spacing;
  } directions[] = {{Vec3(1, 0, 0), 1},
                    {Vec3(1, 1, 0).normalized(), std::sqrt(0.5)},
                    {Vec3(1, 1, 1).normalized(), std::sqrt(1. / 3)}};
  for (int n = 0; n < 3; ++n) {
    const auto [normal, h] = directions[n];
    constexpr double kStep = 1e-3, kMax = 60;
    double sum = 0;
    for (double k = kStep / 2; k < kMax; k += kStep) {
      const double kernel = sharp_transform(k * normal);
      sum += 1 / (k * k) - kernel * kernel * (h * h / (2 - 2 * std::cos(k * h)) - 1. / 12);
    }
    EXPECT_NEAR(kink_along(n), (sum * kStep + 1 / kMax) / std::numbers::pi, 1e-3) << normal.transpose();
  }
}

TEST(MembraneLayer, AtEqualViscositiesThereIsNoSlip) { EXPECT_EQ(layer_corrections(1).slip, 0); }

TEST(MembraneLayer, TheKinkTermNeverTakesPowerFromTheFluid) {
  for (double V = 0.01; V < 200; V *= 1.3) EXPECT_GE(layer_corrections(V).kink, 0) << "V = " << V;
}

TEST(MembraneLayer, SlipReversesItsSignWithTheViscosityRatio) {
  EXPECT_NEAR(layer_corrections(4).slip, -layer_corrections(0.25).slip, 1e-5);
  EXPECT_LT(layer_corrections(4).slip, 0);
}

}  // namespace
}  // namespace capstan
