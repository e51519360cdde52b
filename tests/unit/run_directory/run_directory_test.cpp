#include "solver/run_directory/run_directory.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

class RunDirectoryTest : public ::testing::Test {
 protected:
  TemporaryDirectory parent_;
  RunDirectory directory_{parent_.path() / "run"};
};

/// schema/run_directory.md
TEST(RunDirectoryNames, AreThoseOfTheFileFormat) {
  const RunDirectory directory("run");
  EXPECT_EQ(directory.case_file(), "run/case.json");
  EXPECT_EQ(directory.history_file(), "run/history.jsonl");
  EXPECT_EQ(directory.result_file(), "run/result.json");
  EXPECT_EQ(directory.checkpoint_paths()[0], "run/checkpoint-a.h5");
  EXPECT_EQ(directory.checkpoint_paths()[1], "run/checkpoint-b.h5");
  EXPECT_EQ(directory.mesh_file(), "run/shapes/mesh.h5");
  EXPECT_EQ(directory.shape_index_file(), "run/shapes.xdmf2");
  EXPECT_EQ(directory.log_file(), "run/log");
  EXPECT_EQ(directory.lock_file(), "run/lock");
}

TEST(RunDirectoryNames, NumberFramesWithAtLeastFourDigits) {
  const RunDirectory directory("run");
  EXPECT_EQ(directory.frame_file(0), "run/shapes/0000.h5");
  EXPECT_EQ(directory.frame_file(9999), "run/shapes/9999.h5");
  EXPECT_EQ(directory.frame_file(12345), "run/shapes/12345.h5");
}

TEST(RunDirectoryNames, TellShapesAndCheckpointsFromOtherFiles) {
  const RunDirectory directory("run");
  for (const fs::path& shape : {directory.shape_index_file(), directory.mesh_file(), directory.frame_file(3),
                                directory.rung(42).frame_file(3)})
    EXPECT_TRUE(directory.is_shape(shape) && !directory.is_checkpoint(shape)) << shape;
  for (const fs::path& checkpoint : directory.checkpoint_paths())
    EXPECT_TRUE(directory.is_checkpoint(checkpoint) && !directory.is_shape(checkpoint)) << checkpoint;
  for (const fs::path& other : {directory.case_file(), directory.history_file(), directory.result_file()})
    EXPECT_FALSE(directory.is_shape(other) || directory.is_checkpoint(other)) << other;
}

TEST_F(RunDirectoryTest, IsPreparedWithItsCase) {
  directory_.prepare("{\"Ca\": 0.25}");
  EXPECT_EQ(file_bytes(directory_.case_file()), "{\"Ca\": 0.25}\n");
}

TEST_F(RunDirectoryTest, PreparedAgainKeepsItsFilesAndRepairsADamagedCase) {
  directory_.prepare("{}");
  overwrite(directory_.history_file(), "{\"kt\":1}\n");
  overwrite(directory_.case_file(), "{");
  directory_.prepare("{}");
  EXPECT_EQ(file_bytes(directory_.case_file()), "{}\n");
  EXPECT_EQ(file_bytes(directory_.history_file()), "{\"kt\":1}\n");
}

TEST_F(RunDirectoryTest, IsNotRewrittenWhereTheCaseIsPresent) {
  directory_.prepare("{}");
  const auto before = fs::last_write_time(directory_.case_file());
  directory_.prepare("{}");
  EXPECT_EQ(fs::last_write_time(directory_.case_file()), before);
}

TEST_F(RunDirectoryTest, LosesItsPartialFilesAndNoOthers) {
  EXPECT_FALSE(directory_.has_partial_files());
  directory_.remove_partial_files();  // there is no directory yet
  directory_.prepare("{}");
  fs::create_directory(directory_.shapes_directory());
  const fs::path checkpoint = directory_.checkpoint_paths()[0].string() + ".partial";
  const fs::path frame = directory_.frame_file(0).string() + ".partial";
  for (const fs::path& file : {checkpoint, frame, directory_.frame_file(1)}) overwrite(file, "state");
  EXPECT_TRUE(directory_.has_partial_files());
  directory_.remove_partial_files();
  EXPECT_FALSE(directory_.has_partial_files());
  EXPECT_FALSE(fs::exists(checkpoint) || fs::exists(frame));
  EXPECT_TRUE(fs::exists(directory_.frame_file(1)) && fs::exists(directory_.case_file()));
}

TEST_F(RunDirectoryTest, IsWorthlessUntilItHoldsAResultOrACheckpoint) {
  directory_.prepare("{}");
  overwrite(directory_.history_file(), "{\"kt\":1}\n");
  EXPECT_TRUE(directory_.is_worthless());
  const auto [a, b] = directory_.checkpoint_paths();
  for (const fs::path& file : {directory_.result_file(), a, b}) {
    overwrite(file, "hours of work");
    EXPECT_FALSE(directory_.is_worthless()) << file;
    fs::remove(file);
  }
}

TEST_F(RunDirectoryTest, HasNoResultWhereTheFileIsMissingOrNotWhole) {
  directory_.prepare("{}");
  EXPECT_FALSE(directory_.result());
  for (const char* text : {"", "{\"stop\":", "[]", "null"}) {
    overwrite(directory_.result_file(), text);
    EXPECT_FALSE(directory_.result()) << text;
  }
  overwrite(directory_.result_file(), "{\"stop\": \"steady\"}\n");
  EXPECT_EQ(directory_.result().value()["stop"], "steady");
}

TEST_F(RunDirectoryTest, ReportsAResultThatCannotBeRead) {
  fs::create_directories(directory_.result_file());
  EXPECT_THROW(directory_.result(), fs::filesystem_error);
}

TEST_F(RunDirectoryTest, LogTailHoldsTheLastWholeLines) {
  EXPECT_EQ(directory_.log_tail(), "");
  directory_.prepare("{}");
  overwrite(directory_.log_file(), "first\nsecond\nthird\n\n");
  EXPECT_EQ(directory_.log_tail(), "first\nsecond\nthird");
  EXPECT_EQ(directory_.log_tail(10), "third");
}

TEST_F(RunDirectoryTest, GoesOnFromTheFilesOfAnotherAndKeepsItsOwn) {
  const RunDirectory earlier(parent_.path() / "earlier");
  fs::create_directories(earlier.shapes_directory());
  fs::create_directories(earlier.rung(42).path());
  overwrite(earlier.checkpoint_paths()[1], "its state");
  overwrite(earlier.frame_file(0), "its shape");
  overwrite(earlier.rung(42).checkpoint_paths()[0], "its companion");
  fs::create_directories(directory_.rung(42).path());
  overwrite(directory_.rung(42).checkpoint_paths()[0], "its own companion");
  directory_.go_on_from(earlier);
  EXPECT_EQ(file_bytes(directory_.checkpoint_paths()[1]), "its state");
  EXPECT_EQ(file_bytes(directory_.frame_file(0)), "its shape");
  EXPECT_EQ(file_bytes(directory_.rung(42).checkpoint_paths()[0]), "its own companion");
  EXPECT_FALSE(fs::exists(directory_.result_file()));
}

}  // namespace
}  // namespace capstan
