#include "runner/recording/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "solver/run_directory/durable_file.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

Record record_at(double kt) {
  Record record;
  record["kt"] = kt;
  return record;
}

class HistoryTest : public ::testing::Test {
 protected:
  /// Records at kt = 1, 2 ..
  void store(int count) {
    database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
    for (int kt = 1; kt <= count; ++kt)
      store_history(database_, "a", static_cast<std::size_t>(kt - 1), {record_at(kt)});
  }
  void append(const std::string& text) { std::ofstream(file_, std::ios::app) << text; }

  std::vector<double> stored_times() {
    std::vector<double> times;
    Statement row = database_.query("SELECT kt FROM histories WHERE case_id = 'a' ORDER BY record");
    while (row.step()) times.push_back(row.real(0));
    return times;
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_.path() / "history.jsonl";
  HistoryTail tail_{file_};
  Database database_{directory_.path() / "test.sqlite", Database::Access::write};
};

TEST_F(HistoryTest, RecordsComeOnceAsTheyAreAppended) {
  EXPECT_TRUE(tail_.read_new().records.empty());
  append("{\"kt\":0.1,\"D_xy\":0.5}\n{\"kt\":0.2}\n");
  const auto first = tail_.read_new().records;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0]["D_xy"], 0.5);
  EXPECT_TRUE(tail_.read_new().records.empty());
  append("{\"kt\":0.3}\n");
  EXPECT_EQ(tail_.read_new().records.at(0)["kt"], 0.3);
}

TEST_F(HistoryTest, AReplacedFileBeginsAnew) {
  append("{\"kt\":0.1}\n{\"kt\":0.2}\n");
  EXPECT_TRUE(tail_.read_new().begin_anew);
  append("{\"kt\":0.3}\n");
  const HistoryTail::News appended = tail_.read_new();
  EXPECT_FALSE(appended.begin_anew);
  EXPECT_EQ(appended.first, 2u);
  write_atomically(file_, "{\"kt\":0.15}\n{\"kt\":0.25}\n{\"kt\":0.35}\n{\"kt\":0.45}\n");
  const HistoryTail::News replaced = tail_.read_new();
  EXPECT_TRUE(replaced.begin_anew);
  EXPECT_EQ(replaced.first, 0u);
  ASSERT_EQ(replaced.records.size(), 4u);
  EXPECT_EQ(replaced.records[0]["kt"], 0.15);
}

TEST_F(HistoryTest, AFileBehindALinkIsFollowedToTheNextOne) {
  std::ofstream(directory_.path() / "coarse") << "{\"kt\":0.1}\n{\"kt\":0.2}\n";
  std::ofstream(directory_.path() / "fine") << "{\"kt\":0.1}\n";
  std::filesystem::create_symlink("coarse", file_);
  EXPECT_EQ(tail_.read_new().records.size(), 2u);
  std::filesystem::remove(file_);
  std::filesystem::create_symlink("fine", file_);
  EXPECT_EQ(tail_.read_new().records.size(), 1u);
}

TEST_F(HistoryTest, WhatIsNoNumberIsNaN) {
  append("{\"kt\":1,\"theta\":null,\"psi\":\"x\"}\n");
  const Record record = tail_.read_new().records.at(0);
  EXPECT_TRUE(std::isnan(record["D_xy"]) && std::isnan(record["theta"]) && std::isnan(record["psi"]));
}

TEST_F(HistoryTest, FileCutAtAnyByteGivesItsWholeLines) {
  const std::string line = "{\"kt\":0.1,\"D_xy\":0.5}\n";
  const std::string text = line + line + line;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    std::ofstream(file_) << text.substr(0, length);
    EXPECT_EQ(HistoryTail(file_).read_new().records.size(), length / line.size()) << length;
  }
}

TEST_F(HistoryTest, LineThatIsFinishedLaterIsReadThen) {
  append("{\"kt\":0.1}\n{\"kt\"");
  EXPECT_EQ(tail_.read_new().records.size(), 1u);
  append(":0.2}\n");
  EXPECT_EQ(tail_.read_new().records.at(0)["kt"], 0.2);
}

TEST_F(HistoryTest, StoredRecordsReplaceWhatStoodThere) {
  database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
  store_history(database_, "a", 0, {record_at(1), record_at(2), record_at(3)});
  store_history(database_, "a", 1, {record_at(20)});
  EXPECT_EQ(stored_times(), (std::vector<double>{1, 20, 3}));
}

TEST_F(HistoryTest, FileReplacesWhatStoodThere) {
  store(3);
  append("{\"kt\":10}\n{\"kt\":20}\n{\"kt\":");
  store_history_file(database_, "a", read_history(file_));
  EXPECT_EQ(stored_times(), (std::vector<double>{10, 20}));
}

TEST_F(HistoryTest, FileThatIsMissingOrCannotBeReadLeavesWhatStoodThere) {
  store(3);
  EXPECT_EQ(read_history(file_).damage, "is missing");
  store_history_file(database_, "a", read_history(file_));
  std::filesystem::create_directory(file_);
  EXPECT_EQ(read_history(file_).damage, "cannot be read: Is a directory");
  store_history_file(database_, "a", read_history(file_));
  EXPECT_EQ(stored_times(), (std::vector<double>{1, 2, 3}));
}

TEST_F(HistoryTest, DamagedFileReplacesWhatItCanAndLeavesTheRest) {
  store(3);
  append("{\"kt\":10}\nrubbish\n{\"kt\":30}\n");
  EXPECT_EQ(read_history(file_).damage, "is damaged in line 2");
  store_history_file(database_, "a", read_history(file_));
  EXPECT_EQ(stored_times(), (std::vector<double>{10, 2, 3}));
}

TEST_F(HistoryTest, LinesOfStoredRecordsAreReadAsTheSame) {
  store(2);
  append(history_lines(stored_history(database_, "a")));
  const HistoryFile again = read_history(file_);
  EXPECT_EQ(again.damage, "");
  ASSERT_EQ(again.records.size(), 2u);
  EXPECT_EQ(again.records[1]["kt"], 2);
}

}  // namespace
}  // namespace capstan
