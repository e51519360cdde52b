#include "solver/observe/measure.hpp"

#include <gtest/gtest.h>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"

namespace capstan {
namespace {

TEST(Measure, EveryObservableIsThatOfTheSnapshot) {
  const Icosphere sphere = make_icosphere(2);
  const Points positions = Vec3(2, 0.5, 1).asDiagonal() * sphere.directions;
  const Points none = Points::Zero(3, positions.cols());
  const Record record = measure_all({.parameters = {},
                                     .mesh = sphere.mesh,
                                     .reference = sphere.directions,
                                     .positions = positions,
                                     .velocities = none,
                                     .forces = none,
                                     .motion = {.kt = 1.5, .D_xy = 0.6, .theta = -7, .psi = -2},
                                     .iterations = 12,
                                     .flow_error = 1e-4});
  EXPECT_EQ(record["kt"], 1.5);
  EXPECT_EQ(record["D_xy"], 0.6);
  EXPECT_EQ(record["theta"], -7);
  EXPECT_EQ(record["psi"], -2);
  EXPECT_DOUBLE_EQ(record["volume"], volume(positions, sphere.mesh.faces));
  EXPECT_DOUBLE_EQ(record["area"], area(positions, sphere.mesh.faces));
  EXPECT_EQ(record["iterations"], 12);
  EXPECT_EQ(record["error"], 1e-4);
}

}  // namespace
}  // namespace capstan
