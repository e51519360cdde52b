#include "solver/output/shape_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "solver/mesh/icosphere.hpp"
#include "solver/run_directory/hdf5_file.hpp"
#include "solver/strain_laws/strain_laws.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

class Shapes : public ::testing::Test {
 protected:
  /// Writes frames as one process: spheres of radius 1 + kt, kt = 0.1 frame.
  void write_frames(int first, int last) {
    ShapeWriter writer(directory_.path(), sphere_.mesh.faces, membrane_);
    for (int frame = first; frame <= last; ++frame) {
      const double kt = 0.1 * frame;
      writer.write(kt, frame, (1 + kt) * sphere_.directions, sphere_.directions, -sphere_.directions);
    }
    writer.write_index();
  }

  std::string index() const { return file_bytes(directory_.path() / "shapes.xdmf2"); }

  std::vector<std::string> all_in_index(const std::string& pattern) const {
    const std::string text = index();
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), regex); match != std::sregex_iterator();
         ++match)
      found.push_back((*match)[1]);
    return found;
  }
  std::vector<std::string> times_in_index() const { return all_in_index("Time Value=\"([^\"]*)\""); }

  TemporaryDirectory directory_;
  Icosphere sphere_ = make_icosphere(1);
  InPlaneElasticity membrane_{sphere_.mesh.faces, sphere_.directions, *find_strain_law("skalak"), {1}, 1};
};

TEST_F(Shapes, AreReadBackAsOneRowOfThreeNumbersForEachVertex) {
  write_frames(0, 2);
  const auto positions = Hdf5Reader(directory_.path() / "shapes/0002.h5").read("positions");
  const Points expected = (1 + 0.1 * 2) * sphere_.directions;
  EXPECT_EQ(Eigen::Map<const Points>(positions.data(), 3, 42), expected);
  const auto faces = Hdf5Reader(directory_.path() / "shapes/mesh.h5").read("faces");
  EXPECT_EQ(Eigen::Map<const Points>(faces.data(), 3, 80).cast<int>(), sphere_.mesh.faces);
}

TEST_F(Shapes, HoldTheStretchAtEachVertex) {
  write_frames(5, 5);
  const auto stretches = Hdf5Reader(directory_.path() / "shapes/0005.h5").read("stretches");
  ASSERT_THAT(stretches, SizeIs(42));
  EXPECT_THAT(stretches, Each(DoubleNear(1.5, 1e-12)));
}

TEST_F(Shapes, AreListedWithTheirTimesInShortestDecimals) {
  write_frames(0, 4);
  EXPECT_THAT(times_in_index(), ElementsAre("0", "0.1", "0.2", "0.30000000000000004", "0.4"));
}

TEST_F(Shapes, AreListedOnlyIfTheirFilesAreThere) {
  write_frames(0, 3);
  const auto files = all_in_index(">([^<:]*\\.h5):/");
  EXPECT_EQ(files.size(), 5u * 4);
  for (const std::string& file : files) EXPECT_TRUE(fs::exists(directory_.path() / file)) << file;
}

TEST_F(Shapes, OfAResumedRunEqualThoseOfAnUninterruptedOne) {
  write_frames(0, 5);
  const std::string index_before = index(), frame_before = file_bytes(directory_.path() / "shapes/0003.h5");
  write_frames(3, 4);  // resumed before the last frames, and killed again soon
  EXPECT_THAT(times_in_index(), ElementsAre("0", "0.1", "0.2", "0.30000000000000004", "0.4"));
  write_frames(5, 5);
  EXPECT_EQ(index(), index_before);
  EXPECT_EQ(file_bytes(directory_.path() / "shapes/0003.h5"), frame_before);
}

TEST_F(Shapes, AreIndexedWithoutTheFramesThatAUserRemoved) {
  write_frames(0, 2);
  fs::remove(directory_.path() / "shapes/0001.h5");
  write_frames(3, 3);
  EXPECT_THAT(times_in_index(), ElementsAre("0", "0.2", "0.30000000000000004"));
}

TEST_F(Shapes, AreCountedBeyondFourDigits) {
  write_frames(12345, 12345);
  EXPECT_TRUE(fs::exists(directory_.path() / "shapes/12345.h5"));
}

TEST_F(Shapes, LeaveNoTemporaryFiles) {
  write_frames(0, 3);
  for (const auto& entry : fs::recursive_directory_iterator(directory_.path()))
    EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
}

}  // namespace
}  // namespace capstan
