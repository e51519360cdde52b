#pragma once
// The cubic B-spline as a regularised delta function, in one direction.
//
// Unlike the cosine of the paper (eq. 35) it reproduces linear fields exactly at every position between the
// cells. So a membrane that moves like a rigid body is read without error, forces keep their torque, and the
// second moment, 1/3, is the same at every position: a filter on the grid can remove it (sharpening.hpp).
#include <array>
#include <cmath>

namespace capstan {

/// The weights of the four cells around a point along one axis, and their derivatives.
struct SplineStencil {
  int first;                     ///< index of the first of the four cells
  std::array<double, 4> weight;  ///< their sum is 1
  std::array<double, 4> slope;   ///< d weight / d (centre of the cell), in cells; their sum is 0
};

/// \param position  in cells: the centre of cell i is at i
inline SplineStencil spline_stencil(double position) {
  const double floor = std::floor(position), t = position - floor, r = 1 - t;
  const auto far = [](double u) { return u * u * u / 6; };
  const auto near = [](double u) { return 2. / 3 - u * u + u * u * u / 2; };
  const auto near_slope = [](double u) { return u * (2 - 1.5 * u); };
  return {static_cast<int>(floor) - 1,
          {far(r), near(t), near(r), far(t)},
          {r * r / 2, near_slope(t), -near_slope(r), -t * t / 2}};
}

}  // namespace capstan
