// A real Slurm on this machine, the real daemon and the real solver: its jobs, nodes and controller are lost
// in the middle of studies, and the results are those of an undisturbed local run. The long form, 96 cases on
// four nodes:
//
//   CAPSTAN_SLURM=long build/test/tests/real_slurm_test --gtest_filter='*Survives*'
//   ctest --preset test -R RealSlurm.Long
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "solver/run_directory/run_directory.hpp"
#include "tests/support/campaign.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/private_slurm.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

/// Red cells of a second or less each.
nlohmann::json short_study(const std::string& name, const nlohmann::json& axes, double kt = 5) {
  nlohmann::json document = study_document(name, axes);
  document["base"]["E_b"] = 0.015;
  document["base"]["until"]["kt"] = kt;
  return document;
}

/// One that takes minutes, so that it is still running when something happens to it.
nlohmann::json long_study(const std::string& name) {
  nlohmann::json document = short_study(name, {{"Ca", {0.3}}}, 10000);
  document["base"]["outputs"] = {{"history_every", 1}};
  return document;
}

bool is_long() { return std::getenv("CAPSTAN_SLURM") != nullptr; }

const std::vector<std::string> kSlurm = {"--executor", "slurm"};

class RealSlurm : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PrivateSlurm::is_installed()) GTEST_SKIP() << "Slurm is not installed";
    slurm_.emplace(is_long() ? 4 : 2);
  }

  std::string submit(Client& client, const nlohmann::json& document) {
    return client.post("/v1/studies", document.dump())["id"];
  }
  std::string why(Client& client, const std::string& id) {
    return client.get("/v1/studies/" + id + "/why").dump();
  }
  ordered_json only_case(Client& client, const std::string& id) {
    const ordered_json cases = client.get("/v1/studies/" + id + "/cases");
    return client.get("/v1/cases/" + cases["cases"][0]["id"].get<std::string>());
  }
  /// Until the first case of the study computes on a node, and its first records have arrived.
  std::string node_of(Client& client, const std::string& id) {
    std::string where;
    EXPECT_TRUE(wait_until([&] {
      const ordered_json shown = only_case(client, id);
      where = shown.value("where", "");
      return where.find("on node ") != where.npos && shown["kt"] > 0;
    })) << why(client, id);
    return where.substr(where.rfind(' ') + 1);
  }
  /// As an administrator does: Slurm drains nodes on which it starts a job again that is running there.
  static void resume_drained_nodes() {
    std::system(
        "for n in $(sinfo -h -N -t drain -o %N -r); do scontrol update NodeName=$n State=RESUME; done");
  }
  /// The answers of the same study, computed on this machine.
  std::map<std::string, Answer> local_answers(const nlohmann::json& document, int cases) {
    const TemporaryDirectory data;
    const Daemon daemon(data.path(), {"--cores", "2"});
    Client client(daemon.url());
    const std::string id = submit(client, document);
    EXPECT_TRUE(wait_until([&] { return client.get("/v1/studies/" + id)["cases"]["done"] == cases; }, 10min))
        << why(client, id);
    return answers_in(data.path());
  }

  std::optional<PrivateSlurm> slurm_;
  TemporaryDirectory data_;
};

TEST_F(RealSlurm, StudySurvivesTheLossOfControllerNodeAndDaemonWithTheLocalResults) {
  nlohmann::json axes = {{"Ca", {0.1, 0.2, 0.3, 0.4}}, {"V", {1, 2, 4, 8}}};
  if (is_long())
    axes = {{"Ca", {{"from", 0.05}, {"to", 1}, {"count", 12}}}, {"V", {1, 2, 3, 4, 5, 6, 8, 10}}};
  const int cases = is_long() ? 96 : 16;
  const nlohmann::json document = short_study("survivor", axes, 10);
  auto daemon = std::make_unique<Daemon>(data_.path(), kSlurm);
  std::optional<Client> client(daemon->url());
  const std::string id = submit(*client, document);
  const auto done = [&] { return client->get("/v1/studies/" + id)["cases"]["done"].get<int>(); };
  ASSERT_TRUE(wait_until([&] { return done() >= 2; })) << why(*client, id);
  slurm_->kill_controller();
  daemon->end_with(SIGKILL);
  daemon = std::make_unique<Daemon>(data_.path(), kSlurm);
  client.emplace(daemon->url());
  slurm_->start_controller();
  ASSERT_TRUE(wait_until([&] { return resume_drained_nodes(), done() >= cases / 3; }, 10min))
      << why(*client, id);
  slurm_->lose_node("n1");
  ASSERT_TRUE(wait_until([&] { return resume_drained_nodes(), done() == cases; }, 10min)) << why(*client, id);
  EXPECT_EQ(broken_promise(data_.path()), "");
  EXPECT_TRUE(answers_in(data_.path()) == local_answers(document, cases));
}

TEST_F(RealSlurm, RunOfALostNodeGoesOnElsewhereFromItsCheckpoint) {
  const Daemon daemon(data_.path(), kSlurm);
  Client client(daemon.url());
  const std::string id = submit(client, long_study("lost"));
  const std::string node = node_of(client, id);
  const std::string case_id = only_case(client, id)["id"];
  const RunDirectory run(data_.path() / "runs" / case_id);
  ASSERT_TRUE(wait_until([&] { return !run.is_worthless(); }));
  slurm_->lose_node(node);
  ASSERT_TRUE(wait_until([&] { return only_case(client, id)["attempt"] == 2; })) << why(client, id);
  EXPECT_NE(node_of(client, id), node);
  EXPECT_TRUE(
      wait_until([&] { return file_bytes(run.log_file()).find("resumed at step") != std::string::npos; }));
  const ordered_json first = only_case(client, id)["attempts"][0];
  EXPECT_EQ(first["ending"], "interrupted");
  EXPECT_THAT(first["reason"].get<std::string>(), HasSubstr("its node failed"));
}

TEST_F(RealSlurm, RunAtItsTimeLimitWritesACheckpointAndAnotherJobResumesIt) {
  const Daemon daemon(data_.path(), {"--executor", "slurm", "--time", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, long_study("limit"));
  ASSERT_TRUE(wait_until([&] { return only_case(client, id)["attempt"] == 2; })) << why(client, id);
  const ordered_json first = only_case(client, id)["attempts"][0];
  EXPECT_EQ(first["ending"], "interrupted");
  EXPECT_EQ(first["reason"], "interrupted, a checkpoint is written");
  node_of(client, id);
  const RunDirectory run(data_.path() / "runs" / only_case(client, id)["id"].get<std::string>());
  EXPECT_TRUE(
      wait_until([&] { return file_bytes(run.log_file()).find("resumed at step") != std::string::npos; }));
}

TEST_F(RealSlurm, CaseWaitsForDrainedNodesAndSaysSoUntilTheyAreBack) {
  ASSERT_EQ(std::system("scontrol update NodeName=n1,n2 State=DRAIN Reason=upkeep"), 0);
  const Daemon daemon(data_.path(), kSlurm);
  Client client(daemon.url());
  const std::string id = submit(client, short_study("drained", {{"Ca", {0.5}}}));
  EXPECT_TRUE(wait_until([&] {
    return why(client, id).find("down, drained or reserved") != std::string::npos;
  })) << why(client, id);
  EXPECT_THAT(only_case(client, id)["where"].get<std::string>(), HasSubstr("in Slurm's queue"));
  ASSERT_EQ(std::system("scontrol update NodeName=n1,n2 State=RESUME"), 0);
  wait_for_cases(client, id, "done", 1);
}

TEST_F(RealSlurm, CancelledStudyLeavesNoJob) {
  const Daemon daemon(data_.path(), kSlurm);
  Client client(daemon.url());
  const std::string id = submit(client, long_study("cancelled"));
  node_of(client, id);
  client.post("/v1/studies/" + id + "/cancel", "");
  wait_for_cases(client, id, "cancelled", 1);
  EXPECT_TRUE(wait_until([] { return std::system("test -z \"$(squeue --noheader --me)\"") == 0; }));
}

TEST_F(RealSlurm, JobsGoOnWhileTheDaemonIsStopped) {
  auto daemon = std::make_unique<Daemon>(data_.path(), kSlurm);
  std::string id;
  {
    Client client(daemon->url());
    id = submit(client, short_study("alone", {{"Ca", {0.3, 0.6}}}, 100));
    node_of(client, id);
  }
  EXPECT_EQ(daemon->end_with(SIGTERM), 0);
  EXPECT_TRUE(wait_until([] { return std::system("test -z \"$(squeue --noheader --me)\"") == 0; }));
  daemon = std::make_unique<Daemon>(data_.path(), kSlurm);
  Client client(daemon->url());
  wait_for_cases(client, id, "done", 2);
  EXPECT_EQ(only_case(client, id)["attempt"], 1);
}

TEST_F(RealSlurm, ExportedStudyIsCollectedOnce) {
  const nlohmann::json document = short_study("exported", {{"Ca", {0.3, 0.6, 0.9}}});
  const std::string directory = data_.path() / "exported", data = data_.path() / "data";
  overwrite(data_.path() / "study.json", document.dump());
  const CommandResult exported =
      run_capstan("export-cases " + (data_.path() / "study.json").string() + " " + directory + " --jobs 2");
  ASSERT_EQ(exported.exit_code, 0) << exported.errors;
  ASSERT_EQ(std::system(("cd " + directory + " && sbatch --wait job.sh").c_str()), 0);
  const std::string collect = "collect " + directory + " --data " + data + " --json";
  const CommandResult first = run_capstan(collect);
  EXPECT_EQ(ordered_json::parse(first.output)["recorded"], 3) << first.output << first.errors;
  EXPECT_EQ(ordered_json::parse(run_capstan(collect).output)["known"], 3);
  EXPECT_TRUE(answers_in(data) == local_answers(document, 3));
}

}  // namespace
}  // namespace capstan
