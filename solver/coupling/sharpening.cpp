#include "solver/coupling/sharpening.hpp"

#include <cmath>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

constexpr double kSecond = 1. / 6, kFourth = 7. / 240;

/// second[i] = sum of the six neighbours of the cell i - 6 cell[i], for a row of cells. Neighbouring rows may
/// be missing.
CAPSTAN_VECTOR_UNITS void second_differences(const double* __restrict row, const double* const* neighbours,
                                             double* __restrict second, int count) {
  for (int i = 0; i < count; ++i) second[i] = -6 * row[i];
  for (int i = 1; i < count; ++i) second[i] += row[i - 1];
  for (int i = 0; i < count - 1; ++i) second[i] += row[i + 1];
  for (int n = 0; n < 4; ++n) {
    const double* __restrict other = neighbours[n];
    if (other)
      for (int i = 0; i < count; ++i) second[i] += other[i];
  }
}

void second_differences(const VectorField& field, VectorField& result) {
  const IndexBox& box = field.box();
  result.reset(box);
  for_each_row_in_order(box, [&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      const auto row = [&](int at_y, int at_z) {
        return box.has_row(at_y, at_z) ? field.row(c, at_y, at_z) : nullptr;
      };
      const double* neighbours[] = {row(y - 1, z), row(y + 1, z), row(y, z - 1), row(y, z + 1)};
      second_differences(field.row(c, y, z), neighbours, result.row(c, y, z), box.size(0));
    }
  });
}

}  // namespace

double sharpening_symbol(double kx, double ky, double kz) {
  const double d = 6 - 2 * (std::cos(kx) + std::cos(ky) + std::cos(kz));
  return 1 + kSecond * d + kFourth * d * d;
}

void Sharpening::apply(VectorField& field) {
  second_differences(field, once_);
  second_differences(once_, twice_);
  add_scaled(-kSecond, once_, field);
  add_scaled(kFourth, twice_, field);
}

}  // namespace capstan
