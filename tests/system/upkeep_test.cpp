// `capstan doctor` and `capstan backup` on the data directory of a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <csignal>
#include <fstream>

#include "runner/store/database.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/equal_steps.hpp"
#include "solver/case/parse.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "tests/support/campaign.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class UpkeepTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    const std::string id =
        client.post("/v1/studies", study_document("kept", {{"Ca", {0.25, 0.75}}}).dump())["id"];
    wait_for_cases(client, id, "done", 2);
    case_id_ = client.get("/v1/studies/" + id + "/cases")["cases"][0]["id"];
    EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  }

  CommandResult doctor(const std::string& options = "") {
    return run_capstan("doctor --data " + data_.path().string() + options);
  }
  void expect_error_that_is_repaired(const std::string& what) {
    const CommandResult found = doctor();
    EXPECT_EQ(found.exit_code, 1);
    EXPECT_THAT(found.output, HasSubstr("error: ")) << found.errors;
    EXPECT_THAT(found.output, HasSubstr(what));
    const CommandResult repaired = doctor(" --repair");
    EXPECT_EQ(repaired.exit_code, 0) << repaired.output << repaired.errors;
    EXPECT_THAT(repaired.output, HasSubstr("repaired: "));
    EXPECT_EQ(doctor().output, "all is well\n");
  }
  void change(const char* sql) {
    Database(data_.path() / "capstan.sqlite", Database::Access::write).execute_script(sql);
  }
  fs::path run() const { return data_.path() / "runs" / case_id_; }

  TemporaryDirectory data_, elsewhere_;
  std::string case_id_;
};

TEST_F(UpkeepTest, DoctorFindsNothingWhereAllIsWell) {
  const CommandResult found = doctor();
  EXPECT_EQ(found.exit_code, 0) << found.errors;
  EXPECT_EQ(found.output, "all is well\n");
}

TEST_F(UpkeepTest, DoctorRepairsWrongSums) {
  change("UPDATE tallies SET count = 7 WHERE word = 'done'");
  expect_error_that_is_repaired("are not those of its cases");
}

TEST_F(UpkeepTest, DoctorWritesALostOrChangedResultAgain) {
  const std::string before = file_bytes(run() / "result.json");
  for (const char* damage : {"", "{\"stop\":", "{\"stop\": \"steady\"}"}) {
    overwrite(run() / "result.json", damage);
    expect_error_that_is_repaired("result.json");
    EXPECT_EQ(ordered_json::parse(file_bytes(run() / "result.json")), ordered_json::parse(before));
  }
}

TEST_F(UpkeepTest, DoctorWritesALostOrDamagedHistoryAgain) {
  const fs::path history = run() / "history.jsonl";
  fs::remove(history);
  expect_error_that_is_repaired("history.jsonl is missing; the database holds 10 records");
  overwrite(history, file_bytes(history) + "rubbish\n");
  expect_error_that_is_repaired("history.jsonl is damaged in line 11");
}

TEST_F(UpkeepTest, DoctorStoresAHistoryThatTheDatabaseLacks) {
  change("DELETE FROM histories WHERE record > 3");
  expect_error_that_is_repaired("the database holds 4 of the 10 records");
  Database database(data_.path() / "capstan.sqlite", Database::Access::read);
  Statement row = database.query("SELECT count(*) FROM histories");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.integer(0), 20);
}

TEST_F(UpkeepTest, DoctorSaysThatADoneCaseHasLostItsHistory) {
  change("DELETE FROM histories");
  fs::remove(run() / "history.jsonl");
  EXPECT_THAT(doctor(" --repair").output,
              HasSubstr("error: case " + case_id_ + " is done, but has no history"));
}

TEST_F(UpkeepTest, DoctorQueuesACaseWhoseResultIsLostAgain) {
  change("DELETE FROM results");
  expect_error_that_is_repaired("is done, but has no result");
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id = client.get("/v1/studies")["studies"][0]["id"];
  wait_for_cases(client, id, "done", 2);
}

TEST_F(UpkeepTest, DoctorRemovesPartialFilesAndEmptyOrphans) {
  std::ofstream(run() / "checkpoint-a.h5.partial") << "half";
  expect_error_that_is_repaired("half-written");
  fs::create_directories(data_.path() / "runs" / "00000000deadbeef");
  expect_error_that_is_repaired("belongs to no case");
}

TEST_F(UpkeepTest, DoctorMakesTheDirectoryOfTheRunsAgainWithWhatTheDatabaseHas) {
  fs::remove_all(data_.path() / "runs");
  EXPECT_THAT(doctor().output, HasSubstr("runs is missing"));
  EXPECT_EQ(doctor(" --repair").exit_code, 0);
  EXPECT_EQ(doctor().output, "all is well\n");
}

TEST_F(UpkeepTest, DoctorKeepsAnOrphanThatHoldsWork) {
  const fs::path orphan = data_.path() / "runs" / "00000000deadbeef";
  fs::create_directories(orphan);
  std::ofstream(orphan / "checkpoint-a.h5") << "hours of work";
  EXPECT_EQ(doctor(" --repair").exit_code, 1);
  EXPECT_TRUE(fs::exists(orphan / "checkpoint-a.h5"));
}

/// An interrupted case with two checkpoints, b the newer one.
class InterruptedRun : public UpkeepTest {
 protected:
  void SetUp() override {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    const std::string id =
        client.post("/v1/studies", study_document("half", {{"Ca", {0.25}}, {"V", {70}}}).dump())["id"];
    wait_for_cases(client, id, "running", 1);
    case_id_ = client.get("/v1/studies/" + id + "/cases")["cases"][0]["id"];
    EXPECT_EQ(daemon.end_with(SIGTERM), 0);
    steps_id_ = steps_id(parse_case(nlohmann::json::parse(file_bytes(run() / "case.json"))).value.value());
    write_checkpoint(a_, 1);
    write_checkpoint(b_, 2);
  }
  void write_checkpoint(const char* name, std::uint64_t sequence) {
    overwrite(run() / name, std::string(kCheckpointHeaderSize, '\0') + "the state");
    seal_checkpoint(run() / name,
                    {.numerics = kNumericsVersion, .steps_id = steps_id_, .sequence = sequence});
  }
  void flip_last_byte(const char* name) {
    std::string bytes = file_bytes(run() / name);
    bytes.back() ^= 1;
    overwrite(run() / name, bytes);
  }

  std::string steps_id_;
  const char* const a_ = "checkpoint-a.h5";
  const char* const b_ = "checkpoint-b.h5";
};

TEST_F(InterruptedRun, WithValidCheckpointsHasNoFindings) { EXPECT_EQ(doctor().output, "all is well\n"); }

TEST_F(InterruptedRun, DoctorNotesThatADamagedCheckpointLeavesTheOther) {
  for (const auto& [damaged, other] : {std::pair{a_, b_}, {b_, a_}}) {
    const std::string intact = file_bytes(run() / damaged);
    flip_last_byte(damaged);
    const CommandResult found = doctor(" --repair");
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_THAT(found.output, StartsWith("note: "));
    EXPECT_THAT(found.output, HasSubstr(std::string(damaged) + " fails its checksum"));
    EXPECT_THAT(found.output, HasSubstr("the case goes on from " + std::string(other)));
    overwrite(run() / damaged, intact);
  }
}

TEST_F(InterruptedRun, DoctorSaysThatACaseWithoutAValidCheckpointStartsAnew) {
  flip_last_byte(a_);
  overwrite(run() / b_, "hours of w");
  const std::string found = doctor().output;
  EXPECT_THAT(found, HasSubstr("checkpoint-a.h5 fails its checksum: the case starts anew"));
  EXPECT_THAT(found, HasSubstr("checkpoint-b.h5 is truncated or has no valid header: the case starts anew"));
  expect_error_that_is_repaired("starts anew");
  EXPECT_FALSE(fs::exists(run() / a_));
  EXPECT_FALSE(fs::exists(run() / b_));
}

TEST_F(UpkeepTest, DoctorChecksAServedDirectoryButRepairsNothingThere) {
  const Daemon daemon(data_.path());
  EXPECT_EQ(doctor().exit_code, 0);
  const CommandResult refused = doctor(" --repair");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("another capstan serves"));
}

TEST_F(UpkeepTest, BackupOfARunningDaemonHoldsAllResults) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  client.post("/v1/studies",
              study_document("more", {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 50}}}}).dump());
  const fs::path restored = elsewhere_.path() / "data";
  fs::create_directories(restored);
  const CommandResult backup =
      run_capstan("backup " + (restored / "capstan.sqlite").string() + " --data " + data_.path().string());
  EXPECT_EQ(backup.exit_code, 0) << backup.errors;
  EXPECT_EQ(broken_promise(restored), "");
  const Daemon successor(restored);
  Client again(successor.url());
  const ordered_json studies = again.get("/v1/studies")["studies"];
  EXPECT_FALSE(studies.empty());
  for (const ordered_json& study : studies)
    wait_for_cases(again, study["id"], "done", study["cases"]["total"]);
}

TEST_F(UpkeepTest, BackupReplacesAnEarlierOne) {
  const std::string backup =
      "backup " + (elsewhere_.path() / "copy.sqlite").string() + " --data " + data_.path().string();
  EXPECT_EQ(run_capstan(backup).exit_code, 0);
  EXPECT_EQ(run_capstan(backup).exit_code, 0);
  EXPECT_FALSE(fs::exists(elsewhere_.path() / "copy.sqlite.partial"));
}

/// A file, directory or device at the target that is no earlier backup stays unchanged.
TEST_F(UpkeepTest, BackupReplacesNothingButAnEarlierBackup) {
  const Daemon daemon(data_.path());
  const fs::path there = elsewhere_.path();
  overwrite(there / "text", "not a database");
  overwrite(there / "empty", "");
  fs::create_directory(there / "directory");
  fs::create_symlink(data_.path() / "capstan.sqlite", there / "link");
  fs::create_symlink(there / "nowhere", there / "broken link");
  fs::create_hard_link(data_.path() / "capstan.sqlite", there / "hard link");
  ASSERT_EQ(mkfifo((there / "fifo").c_str(), 0600), 0);
  std::vector<fs::path> targets = {there / "no directory" / "copy.sqlite"};
  const bool has_device = mknod((there / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0;  // as root
  if (has_device) targets.push_back(there / "device");
  for (const char* name : {"capstan.sqlite", "capstan.sqlite-wal", "capstan.sqlite-journal", "lock", "runs"})
    targets.push_back(data_.path() / name);
  for (const char* name : {"text", "empty", "directory", "link", "broken link", "hard link", "fifo"})
    targets.push_back(there / name);
  for (const fs::path& target : targets) {
    const CommandResult refused =
        run_capstan("backup '" + target.string() + "' --data " + data_.path().string());
    EXPECT_EQ(refused.exit_code, 2) << target << refused.output;
    EXPECT_THAT(refused.errors, HasSubstr(target.string()));
  }
  EXPECT_EQ(file_bytes(there / "text"), "not a database");
  EXPECT_TRUE(fs::is_symlink(there / "link") && fs::is_fifo(there / "fifo") && fs::is_empty(there / "empty"));
  EXPECT_TRUE(!has_device || fs::is_character_file(there / "device"));
  Client client(daemon.url());
  EXPECT_EQ(client.get("/readyz")["status"], "ready");
}

TEST_F(UpkeepTest, BackupDoesNotReplaceTheDatabaseOfAnotherDirectory) {
  const TemporaryDirectory other;
  { const Daemon daemon(other.path()); }
  const std::string target = other.path() / "capstan.sqlite";
  EXPECT_EQ(run_capstan("backup " + target + " --data " + data_.path().string()).exit_code, 2);
}

TEST_F(UpkeepTest, BackupThatCannotBeWrittenLeavesTheOldOne) {
  const fs::path copy = elsewhere_.path() / "copy.sqlite";
  overwrite(copy, "the old one");
  const CommandResult backup =
      run_capstan("backup " + copy.string() + " --data " + elsewhere_.path().string());
  EXPECT_EQ(backup.exit_code, 1);
  EXPECT_EQ(file_bytes(copy), "the old one");
}

}  // namespace
}  // namespace capstan
