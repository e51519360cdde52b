#include "solver/grid/transfers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace capstan {
namespace {

constexpr IndexBox kCoarse{{-4, -2, 0}, {5, 6, 6}};
constexpr IndexBox kFine{{-6, -2, 2}, {8, 10, 8}};
const std::vector<double> kOne = {1};

/// f sampled at the centres of the cells of spacing h, ghosts included.
template <class F>
RowField<double> sampled(const IndexBox& box, double h, F f) {
  RowField<double> field(box, 1);
  for (int z = box.lo[2] - 1; z <= box.hi[2]; ++z)
    for (int y = box.lo[1] - 1; y <= box.hi[1]; ++y)
      for (int x = box.lo[0] - 1; x <= box.hi[0]; ++x)
        field.row(0, y, z)[x - box.lo[0]] = f((x + 0.5) * h, (y + 0.5) * h, (z + 0.5) * h);
  return field;
}

double largest_difference(const RowField<double>& a, const RowField<double>& b, const IndexBox& region) {
  double largest = 0;
  for (int z = region.lo[2]; z < region.hi[2]; ++z)
    for (int y = region.lo[1]; y < region.hi[1]; ++y)
      for (int x = region.lo[0]; x < region.hi[0]; ++x)
        largest = std::max(largest,
                           std::abs(a.row(0, y, z)[x - a.box().lo[0]] - b.row(0, y, z)[x - b.box().lo[0]]));
  return largest;
}

double linear(double x, double y, double z) { return 1 + 2 * x - 3 * y + 0.5 * z; }
double parabolic(double x, double y, double z) { return linear(x, y, z) + x * x - 2 * x * y + y * y * z * z; }

TEST(Transfers, ParentsOfNegativeIndicesAreRoundedDown) {
  EXPECT_EQ(parent(-1), -1);
  EXPECT_EQ(parent(-2), -1);
  EXPECT_EQ(parent(-3), -2);
  EXPECT_EQ(parent(1), 0);
  EXPECT_EQ(coarsened(IndexBox{{-3, -2, 0}, {3, 2, 1}}), (IndexBox{{-2, -1, 0}, {2, 1, 1}}));
}

TEST(Transfers, MeanOfTheChildrenOfALinearFieldIsItsValueAtTheParent) {
  const RowField<double> fine = sampled(kFine, 1, linear), exact = sampled(kCoarse, 2, linear);
  RowField<double> coarse(kCoarse, 1);
  const IndexBox region = coarsened(kFine);
  average_children(fine, coarse, region, kOne);
  EXPECT_LT(largest_difference(coarse, exact, region), 1e-12);
}

TEST(Transfers, LinearInterpolationReproducesLinearFields) {
  RowField<double> fine(kFine, 1);
  add_linear(sampled(kCoarse, 2, linear), fine, kFine, kOne);
  EXPECT_LT(largest_difference(fine, sampled(kFine, 1, linear), kFine), 1e-12);
}

TEST(Transfers, InterpolationByParabolasReproducesParabolasInGhostsToo) {
  RowField<double> fine(kFine, 1);
  const IndexBox with_ghosts = grown(kFine, 1);
  interpolate(sampled(kCoarse, 2, parabolic), fine, with_ghosts, kOne);
  EXPECT_LT(largest_difference(fine, sampled(kFine, 1, parabolic), with_ghosts), 1e-11);
}

}  // namespace
}  // namespace capstan
