#pragma once
// Sums over the 4 x 4 x 4 cells around a vertex, for every kernel that has this support.
#include <cstring>

#include "solver/grid/cell_field.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// A row of these cells: one vector register with AVX2.
using FourCells [[gnu::vector_size(32)]] = double;

/// Copies, as the cells of a field are aligned like single numbers.
[[gnu::always_inline]] inline void load(const double* cells, FourCells& numbers) {
  std::memcpy(&numbers, cells, sizeof numbers);
}
[[gnu::always_inline]] inline void store(const FourCells& numbers, double* cells) {
  std::memcpy(cells, &numbers, sizeof numbers);
}

/// Four weights along each axis.
struct CellWeights {
  const double *x, *y, *z;
};

/// \param stencils  along x, y, z
template <class Stencils>
CellWeights weights_of(const Stencils& stencils) {
  return {stencils[0].weight.data(), stencils[1].weight.data(), stencils[2].weight.data()};
}

/// The first of the cells around a vertex.
/// \param stencils  along x, y, z
template <class Field, class Stencils>
auto* first_cell(Field& field, const Stencils& stencils) {
  return field.row(0, stencils[1].first, stencils[2].first) + (stencils[0].first - field.box().lo[0]);
}

/// Adds the vector, times the weights, to the cells.
/// \param cells  component 0 of the first one
void spread_vector(const CellWeights& weights, const Vec3& vector, double* cells, const Strides& strides);

/// The weighted mean of the vectors in the cells.
/// \param cells  component 0 of the first one
Vec3 interpolated_vector(const CellWeights& weights, const double* cells, const Strides& strides);

}  // namespace capstan
