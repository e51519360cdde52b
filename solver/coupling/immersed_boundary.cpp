#include "solver/coupling/immersed_boundary.hpp"

#include <cstring>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// A row of the 4 x 4 x 4 cells around a vertex: one vector register with AVX2.
using FourCells [[gnu::vector_size(32)]] = double;

/// Copies, as the cells of a field are aligned like single numbers.
[[gnu::always_inline]] inline void load(const double* cells, FourCells& numbers) {
  std::memcpy(&numbers, cells, sizeof numbers);
}
[[gnu::always_inline]] inline void store(const FourCells& numbers, double* cells) {
  std::memcpy(cells, &numbers, sizeof numbers);
}

template <class Field>
auto* first_cell(Field& field, const Stencil& stencil) {
  return field.row(0, stencil[1].first, stencil[2].first) + (stencil[0].first - field.box().lo[0]);
}

CAPSTAN_VECTOR_UNITS void spread_one(const Stencil& stencil, const Vec3& force, double* cells,
                                     const Strides& strides) {
  const auto& [sx, sy, sz] = stencil;
  for (int c = 0; c < 3; ++c) {
    FourCells along;
    for (int x = 0; x < 4; ++x) along[x] = force[c] * sx.weight[x];
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        double* row = cells + c * strides.component + z * strides.z + y * strides.y;
        FourCells sums;
        load(row, sums);
        sums += sz.weight[z] * sy.weight[y] * along;
        store(sums, row);
      }
  }
}

CAPSTAN_VECTOR_UNITS Vec3 interpolate_one(const Stencil& stencil, const double* cells,
                                          const Strides& strides) {
  const auto& [sx, sy, sz] = stencil;
  Vec3 sums;
  for (int c = 0; c < 3; ++c) {
    FourCells along = {};
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        FourCells numbers;
        load(cells + c * strides.component + z * strides.z + y * strides.y, numbers);
        along += sz.weight[z] * sy.weight[y] * numbers;
      }
    sums[c] = (along[0] * sx.weight[0] + along[1] * sx.weight[1]) +
              (along[2] * sx.weight[2] + along[3] * sx.weight[3]);
  }
  return sums;
}

}  // namespace

bool ImmersedBoundary::place(const Points& positions, int margin) {
  if (!positions.allFinite()) return false;
  const Vec3 low = (positions.rowwise().minCoeff() - grid_.origin) / grid_.dx;
  const Vec3 high = (positions.rowwise().maxCoeff() - grid_.origin) / grid_.dx;
  constexpr double kMaxDistance = 1e6;  // cells; the index of a much farther one would overflow
  if (low.minCoeff() < -kMaxDistance || high.maxCoeff() > kMaxDistance) return false;
  for (int c = 0; c < 3; ++c) {
    box_.lo[c] = static_cast<int>(std::floor(low[c])) - 1 - margin;
    box_.hi[c] = static_cast<int>(std::floor(high[c])) + 3 + margin;
  }
  stencils_.resize(positions.cols());
  for (Eigen::Index k = 0; k < positions.cols(); ++k)
    for (int c = 0; c < 3; ++c)
      stencils_[k][c] = delta_stencil((positions(c, k) - grid_.origin[c]) / grid_.dx);
  return true;
}

void ImmersedBoundary::spread(const Points& forces, double scale, VectorField& field) const {
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Stencil& stencil = stencils_[k];
    spread_one(stencil, scale * forces.col(Eigen::Index(k)), first_cell(field, stencil), field.strides());
  }
}

void ImmersedBoundary::interpolate(const VectorField& field, double scale, Points& velocities) const {
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Stencil& stencil = stencils_[k];
    velocities.col(Eigen::Index(k)) =
        scale * interpolate_one(stencil, first_cell(field, stencil), field.strides());
  }
}

}  // namespace capstan
