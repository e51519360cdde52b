#include "solver/mesh/shapes.hpp"

#include <cmath>
#include <numbers>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

Points shape_about_y(const Case& c, const Points& directions) {
  switch (c.shape) {
    case Shape::sphere:
      return directions;
    case Shape::oblate:
    case Shape::prolate:
      return spheroid(directions, c.aspect);
    case Shape::biconcave:
      break;
  }
  return biconcave(directions);
}

Points scaled_to_volume_of_unit_sphere(Points positions, const Faces& faces) {
  constexpr double kVolume = 4 * std::numbers::pi / 3;
  positions *= std::cbrt(kVolume / volume(positions, faces));
  return positions;
}

/// Rotates about z by +pi/4, which takes the x axis to the diagonal, or by -pi/4, which takes the y axis
/// there. Sine and cosine are the same number, so that opposite points stay exactly opposite after rounding.
Points turned_by_eighth(const Points& positions, bool x_to_diagonal) {
  constexpr double kSin = 1 / std::numbers::sqrt2;
  const double sine = x_to_diagonal ? kSin : -kSin;
  Points turned = positions;
  turned.row(0) = kSin * positions.row(0) - sine * positions.row(1);
  turned.row(1) = sine * positions.row(0) + kSin * positions.row(1);
  return turned;
}

}  // namespace

Points spheroid(const Points& directions, double aspect) {
  Points positions = directions;
  positions.row(1) *= aspect;
  return positions;
}

Points biconcave(const Points& directions) {
  constexpr double kAlpha = 1.3858, k0 = 0.207, k1 = 2.003, k2 = 1.123;  // eq. 46
  const auto sin2 = directions.row(0).array().square() + directions.row(2).array().square();
  Points positions = kAlpha * directions;
  positions.row(1).array() *= 0.5 * (k0 + k1 * sin2 - k2 * sin2.square());
  return positions;
}

Points initial_positions(const Case& c, const Icosphere& sphere) {
  const Points upright =
      scaled_to_volume_of_unit_sphere(shape_about_y(c, sphere.directions), sphere.mesh.faces);
  if (c.shape == Shape::sphere) return upright;
  const bool major_axis_is_x = c.shape != Shape::prolate;
  return turned_by_eighth(upright, major_axis_is_x);
}

}  // namespace capstan
