// The real daemon with the real solver, killed again and again during one study: at fail points and at random
// moments (SIGKILL), with and without its workers, and workers alone; and terminated (SIGTERM), also just
// after its start and just after its study was cancelled. The long form, some thousand lives:
//
//   CAPSTAN_KILLS=1000 build/test/tests/kill_test        (ctest --preset test -R Kill.Long)
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <random>

#include "runner/store/database.hpp"
#include "tests/support/campaign.hpp"
#include "tests/support/program.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using namespace std::chrono_literals;

int wanted_kills() {
  const char* text = std::getenv("CAPSTAN_KILLS");
  return text ? std::atoi(text) : 200;
}

/// Cases that take fractions of a second, with checkpoints, so that a kill can interrupt the writing of one.
std::string study_of(int cases) {
  return ordered_json{{"name", "kills"},
                      {"base",
                       {{"shape", "sphere"},
                        {"fluid", "stokes"},
                        {"fidelity", {{"nodes", 42}}},
                        {"until", {{"kt", 1}}},
                        {"outputs", {{"history_every", 0.1}, {"checkpoint_every", 2}}}}},
                      {"axes", {{"Ca", {{"from", 0.02}, {"to", 0.2}, {"count", cases}}}}}}
      .dump();
}

class Campaign {
 public:
  explicit Campaign(int kills) : wanted_(kills), cases_(std::max(50, kills / 4)) {}

  /// Answers of the study without any kill.
  std::map<std::string, Answer> undisturbed() {
    const TemporaryDirectory data;
    const Daemon daemon(data.path());
    Client client(daemon.url());
    wait_for_all(client);
    return answers_in(data.path());
  }

  void run() {
    while (kills() < wanted_) {
      live_and_die();
      ASSERT_EQ(broken_promise(data_.path()), "") << "after " << kills() << " kills";
    }
  }

  /// Finishes the study without further kills.
  std::map<std::string, Answer> complete() {
    const Daemon daemon(data_.path());
    Client client(daemon.url());
    wait_for_all(client);
    return answers_in(data_.path());
  }

  void print(int lost, int doubled, int different) const {
    std::cout << "kills: " << at_points_ << " daemons at fail points, " << at_any_moment_
              << " daemons at any moment, " << workers_ << " workers (" << together_
              << " together with the daemon); " << orderly_ << " orderly stops\n"
              << cases_ << " cases: " << lost << " lost, " << doubled << " doubled, " << different
              << " other than undisturbed\n";
  }

  /// Of the daemon, including orderly stops; without those of workers.
  int kills() const { return at_points_ + at_any_moment_ + orderly_; }
  int workers_killed() const { return workers_; }

  std::int64_t crashes() const {
    Database database(data_.path() / "capstan.sqlite", Database::Access::read);
    Statement row = database.query("SELECT count(*) FROM attempts WHERE ending = 'crashed'");
    row.step();
    return row.integer(0);
  }

 private:
  /// Waits up to a minute for each next case, without a limit for all. A case whose worker was killed twice
  /// fails; it is queued again.
  void wait_for_all(Client& client) {
    const std::string study = "/v1/studies/" + submit(client);
    for (int done = 0; done < cases_ && !::testing::Test::HasFailure();) {
      const ordered_json now = wait_for(client, study, [&](const ordered_json& seen) {
        return seen["cases"]["done"] > done || seen["cases"]["failed"] > 0;
      });
      done = now["cases"]["done"];
      if (now["cases"]["failed"] > 0) client.post(study + "/retry", "");
    }
  }

  std::string submit(Client& client) { return client.post("/v1/studies", study_of(cases_))["id"]; }

  /// Keeps the study unfinished as long as there are kills to come: cases may be finished only while their
  /// share is smaller than that of the kills.
  bool may_finish_cases() const {
    if (kills() == 0) return true;
    long done = 0;
    for (const auto& [id, answer] : answers_in(data_.path())) done += answer.state == "done";
    return done * wanted_ < long{cases_} * kills();
  }

  std::string any_fail_point() {
    const bool any = may_finish_cases();
    const std::size_t point = any ? random_() % kFailPoints.size() : 2 + random_() % 4;
    return kFailPoints[point] + std::string(":") + std::to_string(any && point > 1 ? 1 + random_() % 6 : 1);
  }

  void live_and_die() {
    if (random_() % 4 == 0)
      stop_in_order();
    else if (random_() % 2 == 0 || !may_finish_cases())
      die_at(any_fail_point());
    else
      die_at_any_moment();
  }

  void die_at(const std::string& point) try {
    Daemon daemon(data_.path(), {}, point);
    Client client(daemon.url());
    try {
      submit(client);
    } catch (const std::exception&) {  // killed before it answered
    }
    daemon.ends_within(daemon_must_pass(point) ? 60s : 300ms);
    daemon.end_with(SIGKILL);
    ++at_points_;
  } catch (const DaemonDied& death) {  // killed during its start
    EXPECT_EQ(death.exit_code, -SIGKILL) << death.what();
    ++at_points_;
  }

  /// Other fail points may not be reached before the study ends.
  static bool daemon_must_pass(const std::string& point) {
    return point == "submitting:1" || point == "submitted:1";
  }

  void die_at_any_moment() {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    submit(client);
    daemon.ends_within(std::chrono::milliseconds(random_() % 150));
    const bool with_workers = random_() % 2 == 0;
    if (with_workers) kill_workers();
    if (with_workers && random_() % 2 == 0) daemon.ends_within(std::chrono::milliseconds(random_() % 50));
    daemon.end_with(SIGKILL);
    ++at_any_moment_;
  }

  /// Soon after the start, when some processes have not installed their signal handlers.
  void stop_in_order() {
    Daemon daemon(data_.path());
    Client client(daemon.url());
    const std::string id = submit(client);
    daemon.ends_within(std::chrono::milliseconds(may_finish_cases() ? random_() % 60 : random_() % 5));
    if (random_() % 4 == 0) client.post("/v1/studies/" + id + "/cancel", "");
    EXPECT_EQ(daemon.end_with(SIGTERM), 0);
    ++orderly_;
  }

  void kill_workers() {
    for (pid_t worker : workers_of(data_.path())) {
      if (kill(worker, SIGKILL) == 0) ++workers_, ++together_;
      if (random_() % 2 == 0) break;
    }
  }

  const int wanted_;
  const int cases_;
  TemporaryDirectory data_;
  std::mt19937 random_{20240613};
  int at_points_ = 0, at_any_moment_ = 0, workers_ = 0, together_ = 0, orderly_ = 0;
};

TEST(Kill, LeavesEachResultOnceAndAsUndisturbed) {
  Campaign campaign(wanted_kills());
  const std::map<std::string, Answer> expected = campaign.undisturbed();
  campaign.run();
  const std::map<std::string, Answer> found = campaign.complete();
  int lost = 0, doubled = 0, different = 0;
  for (const auto& [id, answer] : expected) {
    const auto there = found.find(id);
    lost += there == found.end() || there->second.state != "done";
    doubled += there != found.end() && there->second.answers > 1;
    different += there == found.end() || there->second != answer;
  }
  campaign.print(lost, doubled, different);
  EXPECT_LE(campaign.crashes(), campaign.workers_killed());
  EXPECT_EQ(found.size(), expected.size());
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(doubled, 0);
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace capstan
