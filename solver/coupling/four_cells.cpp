#include "solver/coupling/four_cells.hpp"

#include "solver/grid/vector_units.hpp"

namespace capstan {

CAPSTAN_VECTOR_UNITS void spread_vector(const CellWeights& weights, const Vec3& vector, double* cells,
                                        const Strides& strides) {
  FourCells weight;
  load(weights.x, weight);
  for (int c = 0; c < 3; ++c) {
    const FourCells along = vector[c] * weight;
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        double* row = cells + c * strides.component + z * strides.z + y * strides.y;
        FourCells numbers;
        load(row, numbers);
        numbers += weights.z[z] * weights.y[y] * along;
        store(numbers, row);
      }
  }
}

CAPSTAN_VECTOR_UNITS Vec3 interpolated_vector(const CellWeights& weights, const double* cells,
                                              const Strides& strides) {
  FourCells weight;
  load(weights.x, weight);
  Vec3 vector;
  for (int c = 0; c < 3; ++c) {
    FourCells along = {};
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y) {
        FourCells numbers;
        load(cells + c * strides.component + z * strides.z + y * strides.y, numbers);
        along += weights.z[z] * weights.y[y] * numbers;
      }
    const FourCells products = along * weight;
    vector[c] = (products[0] + products[1]) + (products[2] + products[3]);
  }
  return vector;
}

}  // namespace capstan
