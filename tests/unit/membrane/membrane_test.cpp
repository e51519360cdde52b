#include "solver/membrane/membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"
#include "tests/support/forces.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;

Case red_blood_cell() {
  Case c;
  c.shape = Shape::biconcave;
  c.law = Law::skalak;
  c.C = 5;
  c.Ca = 0.4;
  c.E_b = 0.015;
  return c;
}

Points forces_of(const Membrane& membrane, const Points& positions) {
  Points forces;
  membrane.forces(positions, forces);
  return forces;
}

TEST(Membrane, ForcesOfTheWholeAreTheNegativeGradientOfItsEnergy) {
  const Icosphere sphere = make_icosphere(2);
  const Points reference = initial_positions(red_blood_cell(), sphere);
  const Membrane membrane(red_blood_cell(), sphere.mesh, reference);
  const Points x = bumped(reference, 0.02);
  const auto energy = [&](const Points& p) { return *membrane.energy(p); };
  EXPECT_LT(relative_error(negative_gradient(energy, x), forces_of(membrane, x)), 1e-7);
}

TEST(Membrane, InitialShapeIsAtRest) {
  const Icosphere sphere = make_icosphere(3);
  const Points reference = initial_positions(red_blood_cell(), sphere);
  const Membrane membrane(red_blood_cell(), sphere.mesh, reference);
  EXPECT_LT(forces_of(membrane, reference).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(*membrane.energy(reference), 0, 1e-12);
}

TEST(Membrane, ForcesGrowWithTheInverseOfTheCapillaryNumber) {
  const Icosphere sphere = make_icosphere(2);
  Case c = red_blood_cell();
  const Points reference = initial_positions(c, sphere), x = bumped(reference, 0.02);
  const Points soft = forces_of(Membrane(c, sphere.mesh, reference), x);
  c.Ca /= 10;
  EXPECT_LT(relative_error(10 * soft, forces_of(Membrane(c, sphere.mesh, reference), x)), 1e-13);
}

TEST(Membrane, HasNoEnergyWithBendingReadLiterally) {
  const Icosphere sphere = make_icosphere(1);
  Case c = red_blood_cell();
  c.bending = BendingModel::helfrich_literal;
  EXPECT_FALSE(Membrane(c, sphere.mesh, sphere.directions).energy(sphere.directions));
}

TEST(Membrane, PositionsThatAreNotFiniteGiveForcesThatAreNotFinite) {
  const Icosphere sphere = make_icosphere(1);
  Points x = sphere.directions;
  x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  for (BendingModel model : {BendingModel::variational, BendingModel::helfrich_literal}) {
    Case c = red_blood_cell();
    c.bending = model;
    EXPECT_FALSE(forces_of(Membrane(c, sphere.mesh, sphere.directions), x).allFinite());
  }
}

TEST(Membrane, CollapsedTrianglesGiveForcesThatAreNotFinite) {
  const Icosphere sphere = make_icosphere(1);
  Points x = sphere.directions;
  x.col(sphere.mesh.faces(1, 0)) = x.col(sphere.mesh.faces(0, 0));
  EXPECT_FALSE(forces_of(Membrane(red_blood_cell(), sphere.mesh, sphere.directions), x).allFinite());
}

}  // namespace
}  // namespace capstan
