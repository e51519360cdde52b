// Real processes that exceed a limit: stopped past their lease, too much memory, too much time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <optional>

#include "runner/daemon/process_identity.hpp"
#include "runner/store/database.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

class RunLimits : public ::testing::Test {
 protected:
  /// One case of that viscosity ratio.
  std::string submit(Client& client, int V) {
    return client.post("/v1/studies", study_document("limits", {{"Ca", {0.25}}, {"V", {V}}}).dump())["id"];
  }
  ordered_json only_case(Client& client, const std::string& id) {
    const ordered_json cases = client.get("/v1/studies/" + id + "/cases");
    return client.get("/v1/cases/" + cases["cases"][0]["id"].get<std::string>());
  }
  /// Waits until the process of the running case is recorded, which happens after the case is claimed.
  ProcessIdentity process_of_the_run() {
    Database database(data_.path() / "capstan.sqlite", Database::Access::read);
    std::optional<ProcessIdentity> process;
    EXPECT_TRUE(wait_until([&] {
      Statement row = database.query("SELECT handle FROM attempts WHERE handle <> '' AND ended_at IS NULL");
      if (row.step()) process = process_from_text(row.text(0));
      return process.has_value();
    }));
    return process.value_or(ProcessIdentity{});
  }

  TemporaryDirectory data_;
};

/// Fencing: a process that loses its lease must never publish a result, although nothing else keeps it from
/// computing one.
TEST_F(RunLimits, ProcessStoppedPastItsLeasePublishesNothingWhenContinued) {
  const Daemon daemon(data_.path(), {"--cores", "1", "--lease", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, 40);
  wait_for_cases(client, id, "running", 1);
  const ProcessIdentity first = process_of_the_run();
  ASSERT_TRUE(is_alive(first));
  kill(first.pid, SIGSTOP);
  const std::string case_id = only_case(client, id)["id"];
  const std::filesystem::path run = data_.path() / "runs" / case_id;
  std::ofstream(run / "go").flush();
  wait_for_cases(client, id, "queued", 1);
  EXPECT_FALSE(is_alive(first));
  kill(first.pid, SIGCONT);
  EXPECT_FALSE(std::filesystem::exists(run / "result.json"));
  wait_for_cases(client, id, "done", 1);
  const ordered_json attempts = only_case(client, id)["attempts"];
  ASSERT_EQ(attempts.size(), 2u);
  EXPECT_EQ(attempts[0]["ending"], "crashed");
  EXPECT_THAT(attempts[0]["reason"].get<std::string>(), HasSubstr("stood still until its lease ran out"));
  EXPECT_EQ(attempts[1]["ending"], "done");
}

TEST_F(RunLimits, LeaseOfAProcessThatComputesIsRenewed) {
  const Daemon daemon(data_.path(), {"--cores", "1", "--lease", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, 40);
  wait_for_cases(client, id, "running", 1);
  const ProcessIdentity run = process_of_the_run();
  EXPECT_FALSE(wait_for_end(run, 3000));
  EXPECT_EQ(only_case(client, id)["attempt"], 1);
}

TEST_F(RunLimits, CaseOverItsMemoryLimitIsStoppedAndSaysHowMuchItTook) {
  const Daemon daemon(data_.path(), {"--memory", "60"});
  Client client(daemon.url());
  const std::string id = submit(client, 45);
  wait_for_cases(client, id, "failed", 1);
  EXPECT_THAT(only_case(client, id)["message"].get<std::string>(),
              HasSubstr("MB of memory; the limit is 60"));
  EXPECT_EQ(only_case(client, id)["crashes"], 0);
}

TEST_F(RunLimits, CaseOverItsTimeLimitIsStoppedAndSaysTheLimit) {
  const Daemon daemon(data_.path(), {"--wall-time", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, 40);
  wait_for_cases(client, id, "failed", 1);
  EXPECT_EQ(only_case(client, id)["message"], "it took longer than the limit of 1 s");
}

}  // namespace
}  // namespace capstan
