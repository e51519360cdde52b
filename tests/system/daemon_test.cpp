// The real daemon with a real database, real processes and a real port, and the fake solver.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "runner/daemon/process_identity.hpp"
#include "runner/store/database.hpp"
#include "tests/support/campaign.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class DaemonTest : public ::testing::Test {
 protected:
  std::string submit(Client& client, const nlohmann::json& axes) {
    return client.post("/v1/studies", study_document("system", axes).dump())["id"];
  }
  ordered_json cases(Client& client, const std::string& id, const std::string& filter = "") {
    return client.get("/v1/studies/" + id + "/cases" + filter)["cases"];
  }
  ordered_json history(Client& client, const ordered_json& shown) {
    return client.get("/v1/cases/" + shown["id"].get<std::string>() + "/history");
  }
  /// Until the cases of the study have written half of their history.
  void wait_for_half(Client& client, const std::string& id) {
    wait_for(client, "/v1/studies/" + id, [](const ordered_json& study) { return study["progress"] == 0.5; });
  }
  std::vector<std::string> endings(Client& client, const ordered_json& shown) {
    std::vector<std::string> all;
    const ordered_json full = client.get("/v1/cases/" + shown["id"].get<std::string>());
    for (const ordered_json& attempt : full["attempts"]) all.push_back(attempt["ending"]);
    return all;
  }
  /// Until the daemon's log holds that many of these requests.
  void wait_for_requests(const std::string& request, int count) {
    EXPECT_TRUE(wait_until([&] {
      const std::string log = file_bytes(data_.path() / "requests.log");
      int found = 0;
      for (auto at = log.find(request); at != log.npos; at = log.find(request, at + 1)) ++found;
      return found >= count;
    })) << request;
  }
  /// Number of crashes of all cases.
  std::int64_t crashes() {
    Database database(data_.path() / "capstan.sqlite", Database::Access::read);
    Statement row = database.query("SELECT total(crashes) FROM cases");
    row.step();
    return row.integer(0);
  }

  TemporaryDirectory data_;
};

TEST_F(DaemonTest, StudyIsComputedClassifiedAndAnswered) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id = submit(client, {{"Ca", {0.25, 0.75}}, {"V", {2, 4}}});
  wait_for_cases(client, id, "done", 4);
  const ordered_json tumbling = cases(client, id, "?motion=tumbling&V=4");
  ASSERT_EQ(tumbling.size(), 1u);
  EXPECT_EQ(tumbling[0]["parameters"]["Ca"], 0.25);
  EXPECT_EQ(tumbling[0]["evidence"]["turns"], 2.0);
  EXPECT_EQ(history(client, tumbling[0])["kt"].size(), 10u);
  EXPECT_EQ(client.get("/v1/studies/" + id)["motions"]["tank_treading"], 2);
}

TEST_F(DaemonTest, EachFailedCaseSaysWhyAndTheOthersFinish) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id = submit(client, {{"Ca", {0.25}}, {"V", {50, 60, 90, 4}}});
  wait_for_cases(client, id, "done", 1);
  wait_for_cases(client, id, "failed", 2);
  wait_for_cases(client, id, "diverged", 1);
  const ordered_json found = cases(client, id);
  EXPECT_EQ(found[0]["message"], "the membrane tore at kt = 0.3");
  EXPECT_EQ(found[1]["message"].get<std::string>().substr(0, 27), "killed by signal 6 (Aborted");
  EXPECT_THAT(endings(client, found[1]), ElementsAre("crashed", "crashed"));
  EXPECT_EQ(found[2]["message"], "the solver refused the case\n/V  cannot be 90");
  EXPECT_THAT(endings(client, found[2]), ElementsAre("failed"));
}

TEST_F(DaemonTest, RunsEndWithAKilledDaemon) {
  Daemon daemon(data_.path());
  Client client(daemon.url());
  wait_for_half(client, submit(client, {{"Ca", {0.25}}, {"V", {70}}}));
  Database database(data_.path() / "capstan.sqlite", Database::Access::read);
  Statement row = database.query("SELECT handle FROM attempts");
  ASSERT_TRUE(row.step());
  const auto run = process_from_text(row.text(0));
  ASSERT_TRUE(run && is_alive(*run));
  daemon.end_with(SIGKILL);
  EXPECT_TRUE(wait_for_end(*run, 10000));
}

TEST_F(DaemonTest, SuccessorOfAKilledDaemonCompletesItsStudies) {
  std::string id;
  {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    id = submit(client, {{"Ca", {0.25, 0.75}}, {"V", {2, 80}}});
    wait_for_cases(client, id, "done", 2);
    wait_for(client, "/v1/studies/" + id + "/cases?V=80", [](const ordered_json& found) {
      return found["cases"][0]["progress"] == 0.5 && found["cases"][1]["progress"] == 0.5;
    });
    daemon.end_with(SIGKILL);
  }
  const Daemon successor(data_.path());
  Client client(successor.url());
  wait_for_cases(client, id, "done", 4);
  for (const ordered_json& shown : cases(client, id, "?V=80")) {
    EXPECT_THAT(endings(client, shown), ElementsAre("interrupted", "done"));
    EXPECT_EQ(history(client, shown)["kt"].size(), 10u);
  }
  for (const ordered_json& shown : cases(client, id, "?V=2")) EXPECT_EQ(shown["attempt"], 1);
}

TEST_F(DaemonTest, TerminatedDaemonHasItsRunsWriteACheckpointAndExitsWith0) {
  Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id = submit(client, {{"Ca", {0.25}}, {"V", {80}}});
  wait_for_half(client, id);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  const Daemon successor(data_.path());
  Client again(successor.url());
  wait_for_cases(again, id, "done", 1);
  EXPECT_THAT(endings(again, cases(again, id)[0]), ElementsAre("interrupted", "done"));
}

/// The signal can arrive before the process of a run has installed its handlers.
TEST_F(DaemonTest, OrderlyStopsSoonAfterTheStartFailNoCase) {
  for (int life = 0; life < 10; ++life) {
    Daemon daemon(data_.path(), {"--cores", "4"});
    Client client(daemon.url());
    submit(client, {{"Ca", {{"from", 0.1}, {"to", 0.8}, {"count", 8}}}, {"V", {40}}});
    daemon.ends_within(std::chrono::milliseconds(3 * life));
    EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  }
  EXPECT_EQ(crashes(), 0);
}

TEST_F(DaemonTest, CancellationsSoonAfterTheStartAreNoCrashes) {
  const Daemon daemon(data_.path(), {"--cores", "4"});
  Client client(daemon.url());
  for (int i = 0; i < 10; ++i) {
    const std::string id = submit(client, {{"Ca", {0.1, 0.2, 0.3, 0.4}}, {"V", {40}}});
    wait_for(client, "/v1/studies/" + id,
             [](const ordered_json& study) { return study["cases"]["running"] > 0; });
    client.post("/v1/studies/" + id + "/cancel", "");
    wait_for_cases(client, id, "cancelled", 4);
  }
  EXPECT_EQ(crashes(), 0);
}

TEST_F(DaemonTest, FilesAreAccessibleToItsUserAlone) {
  const mode_t before = umask(0);
  const std::filesystem::path data = data_.path() / "made by the daemon";
  const Daemon daemon(data);
  umask(before);
  Client client(daemon.url());
  wait_for_cases(client, submit(client, {{"Ca", {0.25}}}), "done", 1);
  namespace fs = std::filesystem;
  constexpr fs::perms kOthers = fs::perms::group_all | fs::perms::others_all;
  EXPECT_EQ(fs::status(data).permissions() & kOthers, fs::perms::none);
  for (const auto& entry : fs::recursive_directory_iterator(data))
    EXPECT_EQ(entry.status().permissions() & kOthers, fs::perms::none) << entry.path();
}

TEST_F(DaemonTest, RunsDoNotInheritTheToken) {
  setenv("CAPSTAN_TOKEN", "0123456789abcdef0123456789abcdef", 1);
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  unsetenv("CAPSTAN_TOKEN");
  const std::string id = submit(client, {{"Ca", {0.25}}, {"V", {70}}});
  wait_for_half(client, id);
  const std::vector<pid_t> workers = workers_of(data_.path());
  ASSERT_EQ(workers.size(), 1u);
  const std::string environment = file_bytes("/proc/" + std::to_string(workers[0]) + "/environ");
  EXPECT_NE(environment.find("CAPSTAN_DAEMON="), environment.npos);
  EXPECT_EQ(environment.find("CAPSTAN_TOKEN"), environment.npos);
}

TEST_F(DaemonTest, CancelledStudyEndsItsRuns) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id = submit(client, {{"Ca", {0.25, 0.5}}, {"V", {70}}});
  wait_for_cases(client, id, "running", 2);
  client.post("/v1/studies/" + id + "/cancel", "");
  wait_for_cases(client, id, "cancelled", 2);
}

TEST_F(DaemonTest, WatchedSubmissionSurvivesARestartOfTheDaemon) {
  auto daemon = std::make_unique<Daemon>(data_.path());
  const std::string address = daemon->url().substr(std::string("http://").size());
  const std::filesystem::path file = data_.path() / "study.json";
  overwrite(file, study_document("watched", {{"Ca", {0.25}}, {"V", {80}}}).dump());
  CommandResult submit;
  std::thread command(
      [&] { submit = run_capstan("submit " + file.string() + " --watch --server " + daemon->url()); });
  Client client(daemon->url());
  const auto study = [&] { return client.get("/v1/studies")["studies"]; };
  wait_for(client, "/v1/studies", [](const ordered_json& list) {
    return list["studies"].size() == 1 && list["studies"][0]["progress"] == 0.5;
  });
  EXPECT_EQ(daemon->end_with(SIGTERM), 0);
  const Daemon successor(data_.path(), {"--listen", address});
  command.join();
  EXPECT_EQ(submit.exit_code, 0) << submit.errors;
  EXPECT_EQ(study()[0]["cases"]["done"], 1);
}

TEST_F(DaemonTest, SubmissionOfAPausedStudyResumesItAndSaysSo) {
  const Daemon daemon(data_.path(), {"--cores", "1"});
  Client client(daemon.url());
  const std::filesystem::path file = data_.path() / "study.json";
  overwrite(file, study_document("paused", {{"Ca", {0.25, 0.5}}, {"V", {70}}, {"fluid", {"stokes"}}}).dump());
  const std::string submission = "submit " + file.string() + " --server " + daemon.url();
  const CommandResult first = run_capstan(submission);
  EXPECT_THAT(first.errors, Not(HasSubstr("paused")));
  const std::string id = first.output.substr(0, first.output.find('\n'));
  client.post("/v1/studies/" + id + "/pause", "");
  EXPECT_THAT(run_capstan(submission).errors, StartsWith("the study was paused, and is resumed\n"));
  EXPECT_EQ(client.get("/v1/studies/" + id)["paused"], false);
}

TEST_F(DaemonTest, WatchSaysThatTheStudyIsPaused) {
  const Daemon daemon(data_.path(), {"--cores", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, {{"Ca", {0.25}}, {"V", {70}}});
  client.post("/v1/studies/" + id + "/pause", "");
  CommandResult watch;
  std::thread command([&] { watch = run_capstan("watch " + id + " --server " + daemon.url()); });
  wait_for_requests("GET /v1/studies/" + id + " 200", 2);
  client.post("/v1/studies/" + id + "/cancel", "");
  command.join();
  EXPECT_NE(watch.output.find("the study is paused, no case is started; go on with:  capstan resume " + id),
            std::string::npos)
      << watch.output;
}

TEST_F(DaemonTest, SecondDaemonCannotTakeThePort) {
  const Daemon daemon(data_.path());
  const TemporaryDirectory other;
  const std::string address = daemon.url().substr(std::string("http://").size());
  const CommandResult second = run_capstan("serve --data " + other.path().string() + " --listen " + address);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_NE(second.errors.find("cannot listen"), std::string::npos) << second.errors;
}

TEST_F(DaemonTest, SecondDaemonCannotTakeTheDataDirectory) {
  const Daemon daemon(data_.path());
  const CommandResult second = run_capstan("serve --data " + data_.path().string() + " --listen 127.0.0.1:0");
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_NE(second.errors.find("another capstan"), std::string::npos) << second.errors;
}

TEST_F(DaemonTest, SecondDaemonCannotTakeTheDataDirectoryEvenIfTheLockFileWasRemoved) {
  const Daemon daemon(data_.path());
  std::filesystem::remove(data_.path() / "lock");
  EXPECT_EQ(run_capstan("serve --data " + data_.path().string() + " --listen 127.0.0.1:0").exit_code, 1);
}

}  // namespace
}  // namespace capstan
