#include "solver/coupling/delta_kernel.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

/// Positions in cells: also cell centres, faces between cells, and negative ones.
std::vector<double> positions() {
  std::vector<double> all;
  for (int i = -30; i <= 30; ++i) all.push_back(i / 12.0);
  return all;
}

/// Paper eq. 35 times dx, x in cells.
double delta(double x) { return std::abs(x) > 2 ? 0 : 0.25 * (1 + std::cos(std::numbers::pi * x / 2)); }

TEST(DeltaKernel, WeightsAreThoseOfThePaper) {
  for (double position : positions()) {
    const DeltaStencil stencil = delta_stencil(position);
    for (int i = -8; i <= 8; ++i) {
      const int n = i - stencil.first;
      EXPECT_NEAR(n >= 0 && n < 4 ? stencil.weight[n] : 0, delta(i - position), 1e-14)
          << "cell " << i << ", position " << position;
    }
  }
}

TEST(DeltaKernel, WeightsSumToOneWhereverThePointIs) {
  for (double position : positions()) {
    const auto& w = delta_stencil(position).weight;
    EXPECT_NEAR(w[0] + w[1] + w[2] + w[3], 1, 1e-15) << position;
  }
}

TEST(DeltaKernel, WeightsAreNeverNegative) {
  for (double position : positions())
    for (double weight : delta_stencil(position).weight) EXPECT_GE(weight, 0) << position;
}

}  // namespace
}  // namespace capstan
