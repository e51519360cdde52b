// Files that are removed or replaced while the real daemon runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/support/file_bytes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class LostFiles : public ::testing::Test {
 protected:
  std::string submit(double Ca, double V = 4) {
    return client_.post("/v1/studies", study_document("files", {{"Ca", {Ca}}, {"V", {V}}}).dump())["id"];
  }
  template <class Ask>
  void expect_unavailable(const Ask& ask, const std::string& why) {
    try {
      ask();
      ADD_FAILURE() << "it was answered";
    } catch (const Refused& refusal) {
      EXPECT_EQ(refusal.status, 503);
      EXPECT_THAT(refusal.what(), HasSubstr(why));
    }
  }
  void expect_study_refused(const std::string& why) {
    expect_unavailable([&] { submit(0.7); }, why);
    expect_unavailable([&] { client_.get("/readyz"); }, why);
  }

  TemporaryDirectory data_, elsewhere_;
  Daemon daemon_{data_.path()};
  Client client_{daemon_.url()};
};

TEST_F(LostFiles, StudyIsRefusedOnceTheDatabaseIsRemoved) {
  const std::string before = submit(0.1);
  wait_for_cases(client_, before, "done", 1);
  for (const char* ending : {"", "-wal", "-shm"})
    fs::remove(data_.path() / ("capstan.sqlite" + std::string(ending)));
  expect_study_refused("capstan.sqlite was removed");
  EXPECT_EQ(client_.get("/v1/studies/" + before)["cases"]["done"], 1);
  daemon_.end_with(SIGTERM);
}

TEST_F(LostFiles, StudyIsRefusedOnceTheDatabaseIsReplaced) {
  wait_for_cases(client_, submit(0.1), "done", 1);
  const fs::path copy = elsewhere_.path() / "copy.sqlite";
  EXPECT_EQ(run_capstan("backup " + copy.string() + " --data " + data_.path().string()).exit_code, 0);
  fs::copy_file(copy, data_.path() / "copy");
  fs::rename(data_.path() / "copy", data_.path() / "capstan.sqlite");
  expect_study_refused("capstan.sqlite was replaced");
}

TEST_F(LostFiles, StudyIsRefusedOnceTheLogIsRemovedAndNothingOfItIsLost) {
  const std::string before = submit(0.1);
  wait_for_cases(client_, before, "done", 1);
  fs::remove(data_.path() / "capstan.sqlite-wal");
  expect_study_refused("capstan.sqlite-wal was removed");
  daemon_.end_with(SIGTERM);
  const Daemon successor(data_.path());
  Client again(successor.url());
  EXPECT_EQ(again.get("/v1/studies/" + before)["cases"]["done"], 1);
}

TEST_F(LostFiles, RemovedDirectoryOfTheRunsIsReportedAndFailsNoCase) {
  const std::string running = submit(0.1, 70);
  wait_for_cases(client_, running, "running", 1);
  fs::remove_all(data_.path() / "runs");
  expect_unavailable([&] { client_.get("/readyz"); }, "runs, where the runs write, cannot be used");
  const std::string id = submit(0.2);
  const std::string shown = client_.get("/v1/studies/" + id + "/cases")["cases"][0]["id"];
  EXPECT_THAT(client_.get("/v1/cases/" + shown + "/why")["reasons"].dump(), HasSubstr("cannot be used"));
  fs::create_directory(data_.path() / "runs");
  EXPECT_EQ(client_.get("/readyz")["status"], "ready");
  wait_for_cases(client_, id, "done", 1);
  EXPECT_EQ(client_.get("/v1/cases/" + shown)["crashes"], 0);
}

}  // namespace
}  // namespace capstan
