#include "solver/run_directory/durable_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

int file_count(const fs::path& directory) {
  return static_cast<int>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

TEST(DurableFile, ReplacesWhatWasThereAndLeavesNothingElse) {
  TemporaryDirectory directory;
  const fs::path path = directory.path() / "result.json";
  write_durably(path, "the first, longer answer");
  write_durably(path, std::string("second\0\n", 8));
  EXPECT_EQ(file_bytes(path), std::string("second\0\n", 8));
  EXPECT_EQ(file_count(directory.path()), 1);
}

TEST(DurableFile, OverwritesTheTemporaryOfAKilledPredecessor) {
  TemporaryDirectory directory;
  const fs::path path = directory.path() / "result.json";
  overwrite(directory.path() / "result.json.partial", "half an ans");
  write_durably(path, "answer");
  EXPECT_EQ(file_bytes(path), "answer");
  EXPECT_EQ(file_count(directory.path()), 1);
}

TEST(DurableFile, KeepsTheOldFileWhenTheNewOneIsNotPublished) {
  TemporaryDirectory directory;
  const fs::path path = directory.path() / "result.json";
  write_durably(path, "old");
  {
    PendingFile file(path);
    overwrite(file.temporary(), "new");
    EXPECT_EQ(file_bytes(path), "old");
  }
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(file_count(directory.path()), 1);
}

TEST(DurableFile, NamesTheOperationAndTheFileThatFailed) {
  TemporaryDirectory directory;
  const fs::path path = directory.path() / "absent" / "result.json";
  try {
    write_durably(path, "answer");
    FAIL() << "nothing was thrown";
  } catch (const fs::filesystem_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot open"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("absent/result.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace capstan
