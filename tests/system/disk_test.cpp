// The real daemon on disks that are full, read-only or damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <random>

#include "runner/doctor/database_checks.hpp"
#include "runner/store/database.hpp"
#include "tests/support/failing_disk.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/small_disk.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using ::testing::HasSubstr;

std::string submit(Client& client, double Ca, double V = 4) {
  return client.post("/v1/studies", study_document("disk", {{"Ca", {Ca}}, {"V", {V}}}).dump())["id"];
}

class DiskTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!disk_.is_mounted()) GTEST_SKIP() << "this user may not mount a tmpfs";
  }

  SmallDisk disk_{"120m"};
  TemporaryDirectory elsewhere_;
};

TEST_F(DiskTest, FullDiskTakesNoStudyLosesNoneAndGoesOnOnceThereIsRoom) {
  Daemon daemon(disk_.path());
  Client client(daemon.url());
  const std::string before = submit(client, 0.1);
  wait_for_cases(client, before, "done", 1);
  disk_.fill();
  int refused = 0;
  std::vector<std::string> taken;
  for (int i = 0; i < 20; ++i) try {
      taken.push_back(submit(client, 0.2 + 0.01 * i));
    } catch (const Refused& refusal) {
      EXPECT_GE(refusal.status, 500);
      ++refused;
    }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(client.get("/v1/studies/" + before)["cases"]["done"], 1);
  disk_.clear();
  taken.push_back(submit(client, 0.9));
  for (const std::string& id : taken) wait_for_cases(client, id, "done", 1);
  EXPECT_EQ(client.get("/v1/studies")["studies"].size(), taken.size() + 1);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
}

TEST_F(DiskTest, FullDiskOfTheRunsLeavesTheCaseQueuedAndWhySaysSo) {
  fs::create_directory_symlink(disk_.path(), elsewhere_.path() / "runs");
  disk_.fill();
  const Daemon daemon(elsewhere_.path());
  Client client(daemon.url());
  const std::string id = submit(client, 0.1);
  const ordered_json shown = client.get("/v1/studies/" + id + "/cases")["cases"][0];
  const ordered_json why = client.get("/v1/cases/" + shown["id"].get<std::string>() + "/why");
  EXPECT_THAT(why["reasons"].dump(), HasSubstr("MB are free in"));
  disk_.clear();
  wait_for_cases(client, id, "done", 1);
  EXPECT_EQ(client.get("/v1/studies/" + id + "/cases")["cases"][0]["attempt"], 1);
}

TEST_F(DiskTest, DaemonOnAFullDiskEndsItsRunsWhenItIsTerminated) {
  Daemon daemon(disk_.path());
  Client client(daemon.url());
  wait_for_cases(client, submit(client, 0.1, 70), "running", 1);
  disk_.fill();
  EXPECT_THAT(daemon.end_with(SIGTERM), ::testing::AnyOf(0, 1));
  disk_.clear();
  const Daemon successor(disk_.path());
  Client again(successor.url());
  EXPECT_EQ(again.get("/v1/studies")["studies"].size(), 1u);
}

TEST_F(DiskTest, DaemonDoesNotStartOnAReadOnlyDiskAndSaysWhy) {
  disk_.make_read_only(true);
  const CommandResult serve = run_capstan("serve --listen 127.0.0.1:0 --data " + disk_.path().string());
  EXPECT_EQ(serve.exit_code, 1);
  EXPECT_THAT(serve.errors, HasSubstr("Read-only file system"));
}

/// Disks that turn read-only while the daemon works on them.
class FailingDiskTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!disk_.is_mounted()) GTEST_SKIP() << "this user may not mount an ext4";
  }
  void expect_refusal_of_studies(Client& client, const std::string& why) {
    for (double Ca : {0.7, 0.8}) try {
        submit(client, Ca);
        ADD_FAILURE() << "a study was taken";
      } catch (const Refused& refusal) {
        EXPECT_EQ(refusal.status, 503);
        EXPECT_THAT(refusal.what(), HasSubstr(why));
      }
  }
  void expect_not_ready(Client& client) {
    try {
      client.get("/readyz");
      ADD_FAILURE() << "it says that it is ready";
    } catch (const Refused& refusal) {
      EXPECT_EQ(refusal.status, 503);
      EXPECT_THAT(refusal.what(), HasSubstr("written"));
    }
  }
  void make_database_unchangeable(bool is_unchangeable) {
    for (const char* end : {"", "-wal", "-shm"})
      make_unchangeable((disk_.path() / "capstan.sqlite").string() + end, is_unchangeable);
  }

  FailingDisk disk_;
};

TEST_F(FailingDiskTest, DatabaseThatCannotBeChangedTakesNoStudyAnswersAllQuestionsAndGoesOnAfterwards) {
  Daemon daemon(disk_.path());
  Client client(daemon.url());
  const std::string before = submit(client, 0.1), during = submit(client, 0.2, 40);
  wait_for_cases(client, before, "done", 1);
  wait_for_cases(client, during, "running", 1);
  make_database_unchangeable(true);
  const std::string run = client.get("/v1/studies/" + during + "/cases")["cases"][0]["id"];
  std::ofstream(disk_.path() / "runs" / run / "go").flush();  // the run ends, and cannot be recorded
  expect_refusal_of_studies(client, "capstan.sqlite: COMMIT: disk I/O error");
  expect_not_ready(client);
  EXPECT_EQ(client.get("/v1/studies/" + before)["cases"]["done"], 1);
  EXPECT_EQ(client.get("/v1/studies")["studies"].size(), 2u);
  make_database_unchangeable(false);
  wait_for_cases(client, during, "done", 1);
  EXPECT_EQ(client.get("/v1/cases/" + run)["attempts"].size(), 1u);
  wait_for_cases(client, submit(client, 0.7), "done", 1);
  EXPECT_EQ(client.get("/readyz")["status"], "ready");
  EXPECT_EQ(client.get("/v1/studies")["studies"].size(), 3u);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
}

/// After a checkpoint of the write-ahead log the next write starts with the log's index, which is shared
/// memory.
TEST_F(FailingDiskTest, FailedDiskDoesNotEndTheDaemonAndLosesNothing) {
  Daemon daemon(disk_.path());
  Client client(daemon.url());
  const std::string before = submit(client, 0.1);
  wait_for_cases(client, before, "done", 1);
  Database(disk_.path() / "capstan.sqlite", Database::Access::write)
      .execute_script("PRAGMA wal_checkpoint(PASSIVE)");
  disk_.fail();
  expect_refusal_of_studies(client, "Read-only file system");
  const CommandResult cancel = run_capstan("cancel " + before + " --server " + daemon.url());
  EXPECT_EQ(cancel.exit_code, 1);
  EXPECT_THAT(cancel.errors, HasSubstr("Read-only file system"));
  expect_not_ready(client);
  EXPECT_EQ(client.get("/v1/studies/" + before)["cases"]["done"], 1);
  EXPECT_THAT(daemon.end_with(SIGTERM), ::testing::AnyOf(0, 1));
  disk_.repair();
  const Daemon successor(disk_.path());
  Client again(successor.url());
  EXPECT_EQ(again.get("/v1/studies/" + before)["cases"]["done"], 1);
  wait_for_cases(again, submit(again, 0.7), "done", 1);
  EXPECT_EQ(again.get("/v1/studies")["studies"].size(), 2u);
}

class DamagedDatabase : public ::testing::Test {
 protected:
  void SetUp() override {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    const std::string id =
        client.post("/v1/studies",
                    study_document("disk", {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", 20}}}}).dump())["id"];
    wait_for_cases(client, id, "done", 20);
    EXPECT_EQ(daemon.end_with(SIGTERM), 0);
    const CommandResult backup = run_capstan("backup " + copy_.string() + " --data " + data_.path().string());
    EXPECT_EQ(backup.exit_code, 0) << backup.errors;
  }

  void overwrite_at(std::streamoff offset, std::size_t size) {
    std::fstream(file_, std::ios::binary | std::ios::in | std::ios::out).seekp(offset)
        << std::string(size, 'x');
  }
  CommandResult doctor(const std::string& options = "") {
    return run_capstan("doctor --data " + data_.path().string() + options);
  }
  /// The study, its cases and their histories; or "no answer" and the reason.
  static std::string all_answers(const Daemon& daemon) {
    Client client(daemon.url());
    std::string answers;
    try {
      const std::string study =
          "/v1/studies/" + client.get("/v1/studies").at("studies").at(0).at("id").get<std::string>();
      const ordered_json cases = client.get(study + "/cases");
      answers = client.get(study).dump() + cases.dump();
      for (const ordered_json& shown : cases["cases"]) {
        const std::string one = "/v1/cases/" + shown["id"].get<std::string>();
        answers += client.get(one).dump() + client.get(one + "/history").dump();
      }
    } catch (const std::exception& error) {
      answers += std::string("no answer: ") + error.what();
    }
    return answers;
  }
  static bool is_not_ready(const Daemon& daemon) try {
    Client(daemon.url()).get("/readyz");
    return false;
  } catch (const Refused& refusal) {
    return refusal.status == 503;
  }

  static constexpr std::size_t kPage = 4096;
  TemporaryDirectory data_, elsewhere_;
  fs::path file_ = data_.path() / "capstan.sqlite", copy_ = elsewhere_.path() / "copy.sqlite";
};

TEST_F(DamagedDatabase, IsNotServedAndTheDoctorSaysSo) {
  overwrite_at(0, 100);
  const CommandResult serve = run_capstan("serve --listen 127.0.0.1:0 --data " + data_.path().string());
  EXPECT_EQ(serve.exit_code, 1);
  EXPECT_THAT(serve.errors, HasSubstr("not a database"));
  EXPECT_EQ(doctor().exit_code, 1);
}

TEST_F(DamagedDatabase, IsFoundByTheDoctorThoughItCanBeOpened) {
  EXPECT_EQ(doctor().exit_code, 0);
  overwrite_at(3 * 4096, 8 * 4096);
  const CommandResult found = doctor();
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_THAT(found.output + found.errors, ::testing::AnyOf(HasSubstr("malformed"), HasSubstr("error: ")));
}

/// Overwrites random pages of the file. Either the daemon does not start, or it answers 503 to requests that
/// read the page and is not ready from then on, or the page was unused and all answers are as before.
TEST_F(DamagedDatabase, OverwrittenPageIsNoticed) {
  const std::string intact = file_bytes(file_);
  std::string expected;
  {
    const Daemon daemon(data_.path());
    expected = all_answers(daemon);
    EXPECT_EQ(expected.find("no answer"), expected.npos);
  }
  std::mt19937 random(20240613);
  for (int i = 0; i < 24; ++i) {
    std::string damaged = intact;
    const std::size_t page = random() % (intact.size() / kPage);
    for (std::size_t byte = 0; byte < kPage; ++byte)
      damaged[page * kPage + byte] = static_cast<char>(random());
    for (const char* end : {"-wal", "-shm"}) fs::remove(file_.string() + end);
    overwrite(file_, damaged);
    try {
      const Daemon daemon(data_.path());
      const std::string answers = all_answers(daemon);
      EXPECT_TRUE(answers == expected || is_not_ready(daemon)) << "page " << page + 1;
    } catch (const DaemonDied& death) {
      EXPECT_EQ(death.exit_code, 1);
    }
  }
}

/// A page that is valid in itself, but holds the rows of another page.
TEST_F(DamagedDatabase, PageReplacedByAnotherPageIsNoticed) {
  constexpr char kLeaf = 10;  // type of a leaf page of an index, as in tables WITHOUT ROWID (the histories)
  const fs::path file = elsewhere_.path() / "swapped.sqlite";
  Database(file, Database::Access::write)
      .execute_script(
          "CREATE TABLE many (a INTEGER, b INTEGER, PRIMARY KEY (a, b)) WITHOUT ROWID;"
          "INSERT INTO many WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5000)"
          " SELECT i, i FROM n");
  EXPECT_NO_THROW(refuse_damaged_database(file));
  std::string bytes = file_bytes(file);
  std::vector<std::size_t> leaves;
  for (std::size_t at = 0; at < bytes.size(); at += kPage)
    if (bytes[at] == kLeaf) leaves.push_back(at);
  ASSERT_GE(leaves.size(), 4u);
  const std::string another = bytes.substr(leaves[leaves.size() - 4], kPage);
  bytes.replace(leaves[leaves.size() - 2], kPage, another);
  overwrite(file, bytes);
  EXPECT_THROW(refuse_damaged_database(file), DatabaseDamaged);
}

TEST_F(DamagedDatabase, IsReplacedByItsBackupWithAllResults) {
  overwrite_at(0, 100);
  for (const char* end : {"", "-wal", "-shm"}) fs::remove(file_.string() + end);
  fs::copy_file(copy_, file_);
  EXPECT_EQ(doctor().exit_code, 0);
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  EXPECT_EQ(client.get("/v1/studies")["studies"][0]["cases"]["done"], 20);
}

}  // namespace
}  // namespace capstan
