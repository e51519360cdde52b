#include "solver/output/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <csignal>
#include <cstring>
#include <limits>

#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kStepsId = "0123456789abcdef";

StateArchive state_at(double kt) {
  StateArchive state;
  state.put("kt", kt);
  state.put("membrane/positions", std::vector<double>{kt, -kt, 0.5, 1.5});
  return state;
}

class Checkpoint : public ::testing::Test {
 protected:
  void write(double kt) { write_checkpoint(directory_.path(), state_at(kt), kStepsId); }

  std::optional<StateArchive> read(const std::string& steps_id = kStepsId) {
    reasons_.clear();
    return read_newest_checkpoint(directory_.path(), steps_id,
                                  [this](const std::string& reason) { reasons_.push_back(reason); });
  }

  /// Time of the checkpoint a run would resume from; -1 for none.
  double newest_kt() {
    const auto state = read();
    return state ? state->number("kt") : -1;
  }

  TemporaryDirectory directory_;
  const fs::path a_ = directory_.path() / "checkpoint-a.h5";
  const fs::path b_ = directory_.path() / "checkpoint-b.h5";
  std::vector<std::string> reasons_;
};

TEST_F(Checkpoint, IsAbsentFromAnEmptyDirectoryWithoutAMessage) {
  EXPECT_FALSE(read());
  EXPECT_THAT(reasons_, IsEmpty());
}

TEST_F(Checkpoint, IsReadBackToTheLastBit) {
  using limits = std::numeric_limits<double>;
  const std::vector<double> odd = {std::bit_cast<double>(0x7ff8'0000'dead'beefULL),
                                   limits::signaling_NaN(),
                                   -0.0,
                                   limits::denorm_min(),
                                   -limits::infinity(),
                                   0.1};
  StateArchive state;
  state.put_view("fluid/level 0/populations", odd);
  state.put("fluid/empty", std::vector<double>{});
  state.put("kt", 0.3);
  write_checkpoint(directory_.path(), state, kStepsId);

  const auto back = read();
  ASSERT_TRUE(back);
  EXPECT_EQ(back->names(), state.names());
  const auto populations = back->get("fluid/level 0/populations");
  ASSERT_EQ(populations.size(), odd.size());
  EXPECT_EQ(std::memcmp(populations.data(), odd.data(), odd.size() * sizeof(double)), 0);
  EXPECT_TRUE(back->get("fluid/empty").empty());
  EXPECT_EQ(back->number("kt"), 0.3);
}

TEST_F(Checkpoint, AlternatesBetweenTwoFilesAndTheNewestIsRead) {
  for (double kt : {1, 2, 3, 4, 5}) {
    write(kt);
    EXPECT_EQ(newest_kt(), kt);
  }
  EXPECT_EQ(read_checkpoint_header(a_)->sequence, 5u);
  EXPECT_EQ(read_checkpoint_header(b_)->sequence, 4u);
}

TEST_F(Checkpoint, TruncatedAnywhereFallsBackToTheOther) {
  write(1);
  write(2);
  const std::string whole = file_bytes(b_);
  for (size_t length = 0; length < whole.size(); length += 1 + length / 50) {
    overwrite(b_, whole.substr(0, length));
    EXPECT_EQ(newest_kt(), 1) << "truncated to " << length << " bytes";
    EXPECT_THAT(reasons_, ElementsAre(HasSubstr("checkpoint-b.h5 is truncated")));
  }
}

TEST_F(Checkpoint, WithAnyByteFlippedFallsBackToTheOther) {
  write(1);
  write(2);
  const std::string whole = file_bytes(b_);
  for (size_t offset = 0; offset < whole.size(); offset += 31) {
    std::string damaged = whole;
    damaged[offset] = static_cast<char>(damaged[offset] ^ 0x10);
    overwrite(b_, damaged);
    EXPECT_EQ(newest_kt(), 1) << "byte " << offset << " flipped";
    EXPECT_EQ(reasons_.size(), 1u);
  }
}

TEST_F(Checkpoint, DamagedIsTheNextToBeReplaced) {
  write(1);
  write(2);
  overwrite(b_, file_bytes(b_).substr(0, 700));
  write(3);
  EXPECT_EQ(read_checkpoint_header(a_)->sequence, 1u);
  EXPECT_EQ(newest_kt(), 3);
}

TEST_F(Checkpoint, BothDamagedMeansNoneAndTwoReasons) {
  write(1);
  write(2);
  overwrite(a_, "");
  overwrite(b_, "");
  EXPECT_FALSE(read());
  EXPECT_EQ(reasons_.size(), 2u);
}

TEST_F(Checkpoint, KilledWhileWritingLeavesBothOldOnesAndDoesNotHinderTheNext) {
  write(1);
  write(2);
  overwrite(directory_.path() / "checkpoint-a.h5.partial", file_bytes(a_).substr(0, 1000));
  EXPECT_EQ(newest_kt(), 2);
  EXPECT_THAT(reasons_, IsEmpty());
  write(3);
  EXPECT_EQ(newest_kt(), 3);
  EXPECT_FALSE(fs::exists(directory_.path() / "checkpoint-a.h5.partial"));
}

/// Limits the size of files of this process during its lifetime, which acts like a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(Checkpoint, ThatDoesNotFitTheDiskThrowsAndLeavesTheOldOnes) {
  write(1);
  write(2);
  StateArchive large;
  large.put("populations", std::vector<double>(1000));
  for (rlim_t limit : {0, 100, 600, 2048, 4096, 8000}) {
    FileSizeLimit full_disk(limit);
    EXPECT_THROW(write_checkpoint(directory_.path(), large, kStepsId), std::runtime_error) << limit;
  }
  EXPECT_EQ(newest_kt(), 2);
  EXPECT_FALSE(fs::exists(directory_.path() / "checkpoint-a.h5.partial"));
  write(3);
  EXPECT_EQ(newest_kt(), 3);
}

TEST_F(Checkpoint, OfAnotherCaseIsPassedOverAndReplacedFirst) {
  write(1);
  EXPECT_FALSE(read("another"));
  EXPECT_THAT(reasons_, ElementsAre(HasSubstr("belongs to a case with other steps, " + kStepsId)));
  write_checkpoint(directory_.path(), state_at(7), "another");
  write_checkpoint(directory_.path(), state_at(8), "another");
  EXPECT_FALSE(read());
  EXPECT_EQ(read("another")->number("kt"), 8);
}

TEST_F(Checkpoint, OfAnotherNumericsVersionOrFormatIsPassedOver) {
  write(1);
  seal_checkpoint(a_, {.numerics = kNumericsVersion + 1, .steps_id = kStepsId, .sequence = 1});
  EXPECT_FALSE(read());
  EXPECT_THAT(reasons_, ElementsAre(HasSubstr("is of numerics version")));
  seal_checkpoint(a_, {.format = 99, .numerics = kNumericsVersion, .steps_id = kStepsId, .sequence = 1});
  EXPECT_FALSE(read());
  EXPECT_THAT(reasons_, ElementsAre(HasSubstr("has format 99")));
}

TEST_F(Checkpoint, IntoAMissingDirectoryNamesTheFileAndTheReason) {
  try {
    write_checkpoint(directory_.path() / "absent", state_at(1), kStepsId);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot create"));
    EXPECT_THAT(error.what(), HasSubstr("absent/checkpoint-a.h5.partial"));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace capstan
