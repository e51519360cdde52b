#include "solver/coupling/spline_boundary.hpp"

#include "solver/coupling/four_cells.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

using Stencils = std::array<SplineStencil, 3>;  ///< along x, y, z

[[gnu::always_inline]] inline double sum(const FourCells& f) { return (f[0] + f[1]) + (f[2] + f[3]); }

/// \param dipole  per cell: 9 numbers, row after row
CAPSTAN_VECTOR_UNITS void spread_dipoles(const Stencils& stencils, const Vec3& force, const double* dipole,
                                         double* cells, const Strides& strides) {
  const auto& [sx, sy, sz] = stencils;
  FourCells weight, slope;
  load(sx.weight.data(), weight), load(sx.slope.data(), slope);
  for (int c = 0; c < 3; ++c) {
    const double* T = dipole + std::ptrdiff_t{3} * c;
    const FourCells along = force[c] * weight - T[0] * slope, in_y = -T[1] * weight, in_z = -T[2] * weight;
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        double* row = cells + c * strides.component + z * strides.z + y * strides.y;
        FourCells numbers;
        load(row, numbers);
        numbers += sz.weight[z] * sy.weight[y] * along + sz.weight[z] * sy.slope[y] * in_y +
                   sz.slope[z] * sy.weight[y] * in_z;
        store(numbers, row);
      }
  }
}

/// \param gradient  per cell: 9 numbers, row after row
CAPSTAN_VECTOR_UNITS Vec3 velocity_and_gradient_at(const Stencils& stencils, const double* cells,
                                                   const Strides& strides, double* gradient) {
  const auto& [sx, sy, sz] = stencils;
  FourCells weight, slope;
  load(sx.weight.data(), weight), load(sx.slope.data(), slope);
  Vec3 velocity;
  for (int c = 0; c < 3; ++c) {
    FourCells along = {}, in_y = {}, in_z = {};
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        FourCells row;
        load(cells + c * strides.component + z * strides.z + y * strides.y, row);
        along += sz.weight[z] * sy.weight[y] * row;
        in_y += sz.weight[z] * sy.slope[y] * row;
        in_z += sz.slope[z] * sy.weight[y] * row;
      }
    velocity[c] = sum(along * weight);
    double* of_component = gradient + std::ptrdiff_t{3} * c;
    of_component[0] = -sum(along * slope);
    of_component[1] = -sum(in_y * weight);
    of_component[2] = -sum(in_z * weight);
  }
  return velocity;
}

}  // namespace

bool SplineBoundary::place(const Points& positions) {
  const std::optional<IndexBox> cells = cells_around(positions, grid_);
  if (!cells) return false;
  box_ = *cells;
  stencils_.resize(std::size_t(positions.cols()));
  for (Eigen::Index k = 0; k < positions.cols(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      stencils_[std::size_t(k)][std::size_t(axis)] =
          spline_stencil((positions(axis, k) - grid_.origin[axis]) / grid_.dx);
  return true;
}

void SplineBoundary::spread(const Points& forces, const Tensors& dipoles, double scale,
                            VectorField& field) const {
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Vec3 force = scale * forces.col(Eigen::Index(k));
    double* cells = first_cell(field, stencils_[k]);
    if (dipoles.cols() == 0) {
      spread_vector(weights_of(stencils_[k]), force, cells, field.strides());
    } else {
      const Eigen::Matrix<double, 9, 1> dipole = scale / grid_.dx * dipoles.col(Eigen::Index(k));
      spread_dipoles(stencils_[k], force, dipole.data(), cells, field.strides());
    }
  }
}

void SplineBoundary::interpolate(const VectorField& field, Points& velocities) const {
  velocities.resize(3, Eigen::Index(stencils_.size()));
  for (std::size_t k = 0; k < stencils_.size(); ++k)
    velocities.col(Eigen::Index(k)) =
        interpolated_vector(weights_of(stencils_[k]), first_cell(field, stencils_[k]), field.strides());
}

void SplineBoundary::interpolate(const VectorField& field, Points& velocities, Tensors& gradients) const {
  velocities.resize(3, Eigen::Index(stencils_.size()));
  gradients.resize(9, Eigen::Index(stencils_.size()));
  for (std::size_t k = 0; k < stencils_.size(); ++k) {
    const Eigen::Index column = Eigen::Index(k);
    velocities.col(column) = velocity_and_gradient_at(stencils_[k], first_cell(field, stencils_[k]),
                                                      field.strides(), gradients.col(column).data());
  }
  gradients /= grid_.dx;
}

}  // namespace capstan
