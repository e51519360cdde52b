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

/// A sphere whose material turns by `angle` inside an ellipse with half axes 2 and 0.5 at 0.2 rad to x.
Points tank_treading(double angle) {
  return turn(0.2) * Vec3(2, 0.5, 1).asDiagonal() * turn(angle) * sphere().directions;
}

TEST(MotionTracker, ARigidBodyTurnsItsShapeAndNotItsMembrane) {
  const Points initial = spheroid_at_start();
  MotionTracker tracker(initial, sphere().mesh.faces);
  Record last;
  for (int step = 1; step <= 100; ++step) last = tracker.observe(step, turn(-0.1 * step) * initial);
  EXPECT_NEAR(last.theta, pi / 4 - 10, 1e-11);
  EXPECT_NEAR(last.psi, 0, 1e-11);
}

TEST(MotionTracker, ATankTreadingEllipsoidTurnsItsMembraneAndNotItsShape) {
  MotionTracker tracker(sphere().directions, sphere().mesh.faces);
  const Record first = tracker.observe(0, tank_treading(0));
  Record last;
  for (int step = 1; step <= 100; ++step) last = tracker.observe(step, tank_treading(-0.1 * step));
  EXPECT_NEAR(last.theta, 0.2, 1e-11);
  EXPECT_NEAR(last.psi - first.psi, -10, 1e-11);
}

TEST(MotionTracker, ASphereStartsOnTheDiagonalWithoutAnyTurning) {
  MotionTracker tracker(sphere().directions, sphere().mesh.faces);
  const Record record = tracker.observe(0, sphere().directions);
  EXPECT_NEAR(record.D_xy, 0, 1e-12);
  EXPECT_DOUBLE_EQ(record.theta, pi / 4);
  EXPECT_NEAR(record.psi, 0, 1e-14);
}

TEST(MotionTracker, RecordsTimeVolumeAndArea) {
  const Points initial = spheroid_at_start();
  MotionTracker tracker(initial, sphere().mesh.faces);
  const Record record = tracker.observe(1.5, initial);
  EXPECT_EQ(record.kt, 1.5);
  EXPECT_DOUBLE_EQ(record.volume, volume(initial, sphere().mesh.faces));
  EXPECT_DOUBLE_EQ(record.area, area(initial, sphere().mesh.faces));
}

TEST(MotionTracker, ResumedFromAnArchiveItGoesOnToTheLastBit) {
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

TEST(History, ALineReadsBackToTheSameBits) {
  const Record record{0.1 + 0.2, 1.0 / 3, -pi, 1e-300, 4.18879, 12.5663, 7, 4e-4};
  EXPECT_EQ(parse_record(to_json_line(record)), record);
}

TEST(History, LinesAreWhatTheSchemaSays) {
  const Record record{0.1, 0.0482, 0.7711, -0.0021, 4.18879, 12.5663, 1, 0.0004};
  EXPECT_EQ(to_json_line(record),
            R"({"kt":0.1,"D_xy":0.0482,"theta":0.7711,"psi":-0.0021,"volume":4.18879,"area":12.5663,)"
            R"("iterations":1,"error":0.0004})");
}

TEST(History, ALineCutAnywhereIsNoRecord) {
  const std::string line = to_json_line({0.1, 0.0482, 0.7711, -0.0021, 4.18879, 12.5663, 1, 0.0004});
  for (size_t length = 0; length < line.size(); ++length)
    EXPECT_FALSE(parse_record(line.substr(0, length))) << length;
}

TEST(History, NumbersThatAreNotFiniteBecomeNull) {
  Record record;
  record.D_xy = std::nan("");
  const std::string line = to_json_line(record);
  EXPECT_NE(line.find("\"D_xy\":null"), std::string::npos);
  EXPECT_TRUE(std::isnan(parse_record(line)->D_xy));
}

}  // namespace
}  // namespace capstan
