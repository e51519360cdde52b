#include "solver/observe/motion_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/shapes.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

const Icosphere& sphere() {
  static const Icosphere instance = make_icosphere(2);
  return instance;
}

Points spheroid_at_start() {
  Case c;
  c.shape = Shape::oblate;
  c.aspect = 0.5;
  return initial_positions(c, sphere());
}

Eigen::Matrix3d turn(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(); }

/// A stretched sphere: the section has half axes 2 and 0.5, the major one at 0.2 rad to x. The material has
/// turned by `angle` in it.
Points tank_treading(double angle) {
  return turn(0.2) * Vec3(2, 0.5, 1).asDiagonal() * turn(angle) * sphere().directions;
}

TEST(MotionTracker, ARigidBodyChangesThetaAndNotPsi) {
  const Points initial = spheroid_at_start();
  MotionTracker tracker(initial, sphere().mesh.faces);
  MotionSample last;
  for (int step = 1; step <= 100; ++step) last = tracker.observe(step, turn(-0.1 * step) * initial);
  EXPECT_NEAR(last.theta, pi / 4 - 10, 1e-11);
  EXPECT_NEAR(last.psi, 0, 1e-11);
}

TEST(MotionTracker, ATankTreadingEllipsoidChangesPsiAndNotTheta) {
  MotionTracker tracker(sphere().directions, sphere().mesh.faces);
  const MotionSample first = tracker.observe(0, tank_treading(0));
  MotionSample last;
  for (int step = 1; step <= 100; ++step) last = tracker.observe(step, tank_treading(-0.1 * step));
  EXPECT_NEAR(last.theta, 0.2, 1e-11);
  EXPECT_NEAR(last.psi - first.psi, -10, 1e-11);
}

TEST(MotionTracker, ASphereStartsWithThetaOfQuarterPi) {
  MotionTracker tracker(sphere().directions, sphere().mesh.faces);
  const MotionSample sample = tracker.observe(0, sphere().directions);
  EXPECT_NEAR(sample.D_xy, 0, 1e-12);
  EXPECT_DOUBLE_EQ(sample.theta, pi / 4);
  EXPECT_NEAR(sample.psi, 0, 1e-14);
}

TEST(MotionTracker, SeesTheSameBitsWhicheverSmallTurnWasObservedBefore) {
  const auto positions = [](double kt) { return Points(turn(-0.17 * kt) * tank_treading(-0.23 * kt)); };
  MotionTracker often(sphere().directions, sphere().mesh.faces), seldom(often);
  for (int step = 0; step < 200; ++step) {
    EXPECT_EQ(often.observe(step, positions(step)), seldom.look(step, positions(step)));
    if (step % 5 == 0) seldom.observe(step, positions(step));
  }
}

TEST(MotionTracker, RestoredFromAnArchiveEqualsTheUninterruptedOne) {
  const auto positions = [](int step) { return Points(turn(-0.17 * step) * tank_treading(-0.23 * step)); };
  MotionTracker uninterrupted(sphere().directions, sphere().mesh.faces);
  for (int step = 0; step < 40; ++step) uninterrupted.observe(step, positions(step));
  StateArchive archive;
  uninterrupted.save(archive);
  MotionTracker resumed(sphere().directions, sphere().mesh.faces);
  resumed.load(archive);
  for (int step = 40; step < 60; ++step)
    EXPECT_EQ(resumed.observe(step, positions(step)), uninterrupted.observe(step, positions(step)));
}

}  // namespace
}  // namespace capstan
