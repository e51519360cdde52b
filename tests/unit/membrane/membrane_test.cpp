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
  c.law = find_strain_law("skalak");
  c.law_constants = {5};
  c.Ca = 0.4;
  c.E_b = 0.015;
  return c;
}

Orbits whole(const Icosphere& sphere) { return Orbits::without_symmetry(sphere.mesh.vertex_count()); }

Points forces_of(const Membrane& membrane, const Points& positions) {
  Points forces;
  membrane.forces(positions, forces);
  return forces;
}

TEST(Membrane, ForcesOfTheWholeAreTheNegativeGradientOfItsEnergy) {
  const Icosphere sphere = make_icosphere(2);
  const Points reference = initial_positions(red_blood_cell(), sphere);
  const Membrane membrane(red_blood_cell(), sphere.mesh, reference, whole(sphere));
  const Points x = bumped(reference, 0.02);
  const auto energy = [&](const Points& p) { return *membrane.energy(p); };
  EXPECT_LT(relative_error(negative_gradient(energy, x), forces_of(membrane, x)), 1e-7);
}

TEST(Membrane, InitialShapeIsAtRest) {
  const Icosphere sphere = make_icosphere(3);
  const Points reference = initial_positions(red_blood_cell(), sphere);
  const Membrane membrane(red_blood_cell(), sphere.mesh, reference, whole(sphere));
  EXPECT_LT(forces_of(membrane, reference).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(*membrane.energy(reference), 0, 1e-12);
}

TEST(Membrane, ForcesOfAQuarterAndItsImagesAreThoseOfTheWhole) {
  const Icosphere sphere = make_icosphere(3);
  Case c = red_blood_cell();
  const Points reference = initial_positions(c, sphere);
  Points x = reference;  // strained with the symmetry of the flow
  x.row(0) += 0.2 * reference.row(1);
  x.row(2) *= 1.1;
  const auto preferred = {SpontaneousCurvature(InitialCurvature{}), SpontaneousCurvature(UniformCurvature{}),
                          SpontaneousCurvature(-2.0)};
  for (BendingModel model : {BendingModel::variational, BendingModel::helfrich_literal})
    for (const SpontaneousCurvature& c0 : preferred) {
      c.bending = model, c.c0 = c0;
      const Points exact = forces_of(Membrane(c, sphere.mesh, reference, whole(sphere)), x);
      EXPECT_LT(
          relative_error(exact, forces_of(Membrane(c, sphere.mesh, reference, Orbits::of(reference)), x)),
          1e-13);
    }
}

TEST(Membrane, ForcesGrowWithTheInverseOfTheCapillaryNumber) {
  const Icosphere sphere = make_icosphere(2);
  Case c = red_blood_cell();
  const Points reference = initial_positions(c, sphere), x = bumped(reference, 0.02);
  const Points soft = forces_of(Membrane(c, sphere.mesh, reference, whole(sphere)), x);
  c.Ca /= 10;
  EXPECT_LT(relative_error(10 * soft, forces_of(Membrane(c, sphere.mesh, reference, whole(sphere)), x)),
            1e-13);
}

TEST(Membrane, HasNoEnergyWithBendingReadLiterally) {
  const Icosphere sphere = make_icosphere(1);
  Case c = red_blood_cell();
  c.bending = BendingModel::helfrich_literal;
  EXPECT_FALSE(Membrane(c, sphere.mesh, sphere.directions, whole(sphere)).energy(sphere.directions));
}

TEST(Membrane, PositionsThatAreNotFiniteGiveForcesThatAreNotFinite) {
  const Icosphere sphere = make_icosphere(1);
  Points x = sphere.directions;
  x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  for (BendingModel model : {BendingModel::variational, BendingModel::helfrich_literal}) {
    Case c = red_blood_cell();
    c.bending = model;
    EXPECT_FALSE(forces_of(Membrane(c, sphere.mesh, sphere.directions, whole(sphere)), x).allFinite());
  }
}

TEST(Membrane, CollapsedTrianglesGiveForcesThatAreNotFinite) {
  const Icosphere sphere = make_icosphere(1);
  Points x = sphere.directions;
  x.col(sphere.mesh.faces(1, 0)) = x.col(sphere.mesh.faces(0, 0));
  EXPECT_FALSE(
      forces_of(Membrane(red_blood_cell(), sphere.mesh, sphere.directions, whole(sphere)), x).allFinite());
}

}  // namespace
}  // namespace capstan
