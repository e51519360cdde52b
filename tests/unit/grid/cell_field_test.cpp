#include "solver/grid/cell_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "solver/grid/for_each_row.hpp"

namespace capstan {
namespace {

/// A different number in each cell.
ScalarField numbered_field(const IndexBox& box) {
  ScalarField field;
  field.reset(box);
  double value = 0;
  for_each_row_in_order(box, [&](int y, int z) {
    for (int i = 0; i < box.size(0); ++i) field.row(0, y, z)[i] = std::sin(value += 1);
  });
  return field;
}

/// Sum over all cells of the difference from `outside`.
double excess(const ScalarField& field, double outside) {
  return std::accumulate(field.values().begin(), field.values().end(),
                         -outside * double(field.values().size()));
}

TEST(CellField, CoarseningKeepsTheSumForEvenAndOddBoxes) {
  for (int lo : {4, 5})
    for (int size : {6, 7}) {
      const ScalarField fine = numbered_field({{lo, 8, lo + 1}, {lo + size, 13, lo + 5}});
      EXPECT_NEAR(8 * excess(coarsened(fine, 0.3), 0.3), excess(fine, 0.3), 1e-12)
          << "lo " << lo << ", size " << size;
    }
}

TEST(CellField, CoarsenedCellIsTheMeanOfItsEightChildren) {
  const ScalarField fine = numbered_field({{2, 4, 6}, {6, 8, 10}});
  const ScalarField coarse = coarsened(fine, 9);
  double mean = 0;
  for (int z : {8, 9})
    for (int y : {4, 5})
      for (int i : {2, 3}) mean += fine.row(0, y, z)[i] / 8;
  EXPECT_NEAR(coarse.row(0, 2, 4)[1], mean, 1e-14);
  EXPECT_EQ(coarse.box(), (IndexBox{{1, 2, 3}, {3, 4, 5}}));
}

TEST(CellField, CoarseningAgainAndAgainKeepsTheSum) {
  ScalarField field = numbered_field({{13, 12, 11}, {22, 23, 24}});
  const double all = excess(field, 2);
  for (double share = 8; share <= 512; share *= 8) {
    field = coarsened(field, 2);
    EXPECT_NEAR(share * excess(field, 2), all, 1e-10 * std::abs(all));
  }
}

}  // namespace
}  // namespace capstan
