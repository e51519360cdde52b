#include "solver/grid/cell_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace capstan {
namespace {

ScalarBox numbered_box(std::array<int, 3> lo, std::array<int, 3> size) {
  ScalarBox box;
  box.reset(lo, size);
  double value = 0;
  box.for_each_row([&](int y, int z) {
    for (int i = 0; i < size[0]; ++i) box.row(0, y, z)[i] = std::sin(value += 1);
  });
  return box;
}

/// Sum of what differs from `outside`.
double excess(const ScalarBox& box, double outside) {
  return std::accumulate(box.values().begin(), box.values().end(), -outside * double(box.values().size()));
}

TEST(CellBox, CoarsenedKeepsTheSumWhereverTheBoxBegins) {
  for (int lo : {4, 5})
    for (int size : {6, 7}) {
      const ScalarBox fine = numbered_box({lo, 8, lo + 1}, {size, 5, 4});
      EXPECT_NEAR(8 * excess(coarsened(fine, 0.3), 0.3), excess(fine, 0.3), 1e-12)
          << "lo " << lo << ", size " << size;
    }
}

TEST(CellBox, CoarsenedCellIsTheMeanOfItsEightChildren) {
  const ScalarBox fine = numbered_box({2, 4, 6}, {4, 4, 4});
  const ScalarBox coarse = coarsened(fine, 9);
  double mean = 0;
  for (int z : {8, 9})
    for (int y : {4, 5})
      for (int i : {2, 3}) mean += fine.row(0, y, z)[i] / 8;
  EXPECT_NEAR(coarse.row(0, 2, 4)[1], mean, 1e-14);
  EXPECT_EQ(coarse.lo(), (std::array{1, 2, 3}));
  EXPECT_EQ(coarse.size(), (std::array{2, 2, 2}));
}

TEST(CellBox, CoarsenedToTheCoarsestLevelStillHoldsWhatTheFinestDid) {
  ScalarBox box = numbered_box({13, 12, 11}, {9, 11, 13});
  const double all = excess(box, 2);
  for (double share = 8; share <= 512; share *= 8) {
    box = coarsened(box, 2);
    EXPECT_NEAR(share * excess(box, 2), all, 1e-10 * std::abs(all));
  }
}

}  // namespace
}  // namespace capstan
