#pragma once
// The regularised delta function of the immersed boundary method (paper eq. 35), in one direction.
#include <array>
#include <cmath>
#include <numbers>

namespace capstan {

/// The weights of the four cells around a point, along one axis.
struct DeltaStencil {
  int first;                     ///< index of the first of the four cells
  std::array<double, 4> weight;  ///< their sum is 1 for every position
};

using Stencil = std::array<DeltaStencil, 3>;  ///< along x, y, z

/// dx * delta_h(x) = 1/4 (1 + cos(pi x / (2 dx))) for |x| <= 2 dx.
/// \param position  in cells: the centre of cell i is at i
inline DeltaStencil delta_stencil(double position) {
  DeltaStencil stencil{static_cast<int>(std::floor(position)) - 1, {}};
  // cos(angle - n pi/2) for n = 0..3 from one sine and one cosine
  const double angle = std::numbers::pi / 2 * (position - stencil.first);
  const double c = std::cos(angle), s = std::sin(angle);
  stencil.weight = {0.25 * (1 + c), 0.25 * (1 + s), 0.25 * (1 - c), 0.25 * (1 - s)};
  return stencil;
}

}  // namespace capstan
