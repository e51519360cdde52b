#pragma once
// The filter that removes the smoothing by the kernel of the coupling.
//
// The Fourier transform of the cubic B-spline is (sin(k/2) / (k/2))^4 (k in 1/cells); its reciprocal is
//   1 + k^2/6 + 11 k^4/720 + O(k^6) = 1 + d/6 + 7 d^2/240 + O(k^6),   d = 2 - 2 cos k = k^2 - k^4/12 + ...,
// and -d is the transform of the second difference. So
//   G = 1 - delta^2/6 + 7/240 delta^2 delta^2,
// with delta^2 the sum of the second differences along the three axes, makes the kernel one whose moments
// two to five vanish. (In three dimensions delta^2 delta^2 also has mixed terms, which are of fourth order.)
// G is symmetric: used after the forces are spread and before velocities are interpolated, it leaves these
// operations adjoint to each other.
#include <vector>

#include "solver/grid/cell_field.hpp"

namespace capstan {

/// Cells around a cell that G reads.
inline constexpr int kSharpeningReach = 2;

/// The symbol of G for k = (kx, ky, kz), in 1/cells.
double sharpening_symbol(double kx, double ky, double kz);

class Sharpening {
 public:
  /// field <- G field. Cells outside of the field's box count as zero.
  void apply(VectorField& field);

 private:
  VectorField once_;                   ///< scratch: delta^2 field
  std::vector<double> zeros_, twice_;  ///< scratch: a row of zeros; a row of delta^2 delta^2 field
};

}  // namespace capstan
