#include "solver/run_directory/recorded_shapes.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "solver/run_directory/hdf5_file.hpp"
#include "tests/support/recorded_sphere.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class RecordedShapes : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
  RunDirectory run_{directory_.path()};
};

TEST_F(RecordedShapes, HaveTheTimesAndFilesOfTheIndex) {
  record_spheres(run_.path());
  const auto shapes = recorded_shapes(run_);
  ASSERT_THAT(shapes, SizeIs(3));
  EXPECT_EQ(shapes[2].kt, 1);
  EXPECT_EQ(shapes[2].number, 2);
}

TEST_F(RecordedShapes, AreTheArraysThatTheRunWrote) {
  record_spheres(run_.path());
  const ShapeArrays arrays = read_shape(run_, {1, 2});
  const Icosphere sphere = recorded_sphere();
  EXPECT_EQ(Eigen::Map<const Points>(arrays.positions.data(), 3, 42), 2 * sphere.directions);
  EXPECT_EQ(Eigen::Map<const Points>(arrays.velocities.data(), 3, 42), sphere.directions);
  EXPECT_EQ(Eigen::Map<const Points>(arrays.forces.data(), 3, 42), -2 * sphere.directions);
  EXPECT_THAT(arrays.stretches, Each(DoubleNear(2, 1e-12)));
  EXPECT_EQ(Eigen::Map<const Faces>(read_triangles(run_).data(), 3, 80), sphere.mesh.faces);
}

TEST_F(RecordedShapes, OfARunWithoutAnIndexAreNone) { EXPECT_THAT(recorded_shapes(run_), IsEmpty()); }

TEST_F(RecordedShapes, OfADamagedIndexAreThoseThatCanBeRead) {
  std::ofstream(run_.shape_index_file())
      << R"(<Time Value="0.5"></Time><Geometry><DataItem>shapes/0001.h5:/positions</DataItem></Geometry>)"
      << R"(<Time Value="later"></Time><Geometry><DataItem>shapes/0002.h5:/positions</DataItem></Geometry>)"
      << R"(<Time Value="1"></Time>)";
  EXPECT_THAT(recorded_shapes(run_), ElementsAre(Field(&RecordedShape::number, 1)));
}

TEST_F(RecordedShapes, OfAnEarlierVersionHaveNoStretches) {
  std::filesystem::create_directories(run_.shapes_directory());
  Hdf5Writer file(run_.frame_file(0));
  const std::vector<double> vectors(9, 0.0);
  for (const char* name : {"positions", "velocities", "forces"}) file.write(name, vectors, 3);
  file.close();
  EXPECT_THAT(read_shape(run_, {0, 0}).stretches, IsEmpty());
}

TEST_F(RecordedShapes, WithoutTheirFileAreAnErrorThatNamesIt) {
  EXPECT_THAT(
      [&] {
        read_shape(run_, {0, 7});
      },
      ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("shapes/0007.h5")));
}

TEST_F(RecordedShapes, AreReadByManyThreadsAtOnce) {
  record_spheres(run_.path());
  const ShapeArrays expected = read_shape(run_, {0, 0});
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) EXPECT_EQ(read_shape(run_, {0, 0}).positions, expected.positions);
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace capstan
