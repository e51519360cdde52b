#include "solver/coupling/sharpening.hpp"

#include <cmath>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr double kSecond = 1. / 6, kFourth = 7. / 240;

/// A row of cells and the four next to it.
struct Rows {
  const double *row, *below, *above, *before, *behind;
};

/// second[i] = sum of the six neighbours of the cell i - 6 times the cell. Beyond the ends of the row the
/// field is zero.
CAPSTAN_VECTOR_UNITS void put_second_differences(const Rows& rows, int count, double* __restrict second) {
  const double *row = rows.row, *below = rows.below, *above = rows.above, *before = rows.before,
               *behind = rows.behind;
  for (int i = 1; i < count - 1; ++i)
    second[i] = (below[i] + above[i]) + (before[i] + behind[i]) + (row[i - 1] + row[i + 1]) - 6 * row[i];
  const auto at_end = [&](int i, double next) {
    second[i] = (below[i] + above[i]) + (before[i] + behind[i]) + next - 6 * row[i];
  };
  at_end(0, count > 1 ? row[1] : 0);
  if (count > 1) at_end(count - 1, row[count - 2]);
}

/// Calls visit(rows, component, y, z) for all rows of a field. `zeros` stands for the rows outside of the
/// box.
template <class Visit>
void for_each_row_and_its_neighbours(const VectorField& field, const double* zeros, Visit visit) {
  const IndexBox& box = field.box();
  for_each_row_in_order(box, [&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      const auto row = [&](int at_y, int at_z) {
        return box.has_row(at_y, at_z) ? field.row(c, at_y, at_z) : zeros;
      };
      visit(Rows{row(y, z), row(y - 1, z), row(y + 1, z), row(y, z - 1), row(y, z + 1)}, c, y, z);
    }
  });
}

/// row += -kSecond once + kFourth twice
CAPSTAN_VECTOR_UNITS void add_differences(const double* __restrict once, const double* __restrict twice,
                                          int count, double* __restrict row) {
  for (int i = 0; i < count; ++i) row[i] += kFourth * twice[i] - kSecond * once[i];
}

}  // namespace

double sharpening_symbol(double kx, double ky, double kz) {
  const double d = 6 - 2 * (std::cos(kx) + std::cos(ky) + std::cos(kz));
  return 1 + kSecond * d + kFourth * d * d;
}

void Sharpening::apply(VectorField& field) {
  const IndexBox& box = field.box();
  const int count = box.size(0);
  once_.reset(box);
  zeros_.assign(std::size_t(count), 0);
  twice_.resize(std::size_t(count));
  for_each_row_and_its_neighbours(field, zeros_.data(), [&](const Rows& rows, int c, int y, int z) {
    put_second_differences(rows, count, once_.row(c, y, z));
  });
  for_each_row_and_its_neighbours(once_, zeros_.data(), [&](const Rows& rows, int c, int y, int z) {
    put_second_differences(rows, count, twice_.data());
    add_differences(rows.row, twice_.data(), count, field.row(c, y, z));
  });
}

}  // namespace capstan
