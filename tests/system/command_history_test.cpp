// Random sequences of commands to a daemon that is killed at fail points and at random moments. A command
// that was answered must hold in all later lives of the daemon. A command without an answer is sent again, as
// a client would.
//
//   CAPSTAN_SEED=7 CAPSTAN_LIVES=500 build/test/tests/program_test --gtest_filter=CommandHistory.*
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

#include "tests/support/campaign.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

/// The studies share cases. All values of V are kinds of the fake solver (tests/support/fake_solver.cpp) that
/// end by themselves.
const std::vector<json> kAxes = {
    {{"Ca", {0.1, 0.2}}, {"V", {2, 4}}},  {{"Ca", {0.2, 0.3}}, {"V", {4, 50}}},
    {{"Ca", {0.1, 0.3}}, {"V", {4, 90}}}, {{"Ca", {0.4}}, {"V", {2, 60}}},
    {{"Ca", {0.1, 0.4}}, {"V", {2, 5}}},
};

std::string state_that_ends(double V) {
  return V == 50 ? "diverged" : V == 60 || V == 90 ? "failed" : "done";
}

/// The state of a study according to the server's answers so far.
struct Known {
  std::string id;
  bool is_paused = false, is_cancelled = false;
  int priority = 0;
};

class CommandSequence {
 public:
  explicit CommandSequence(unsigned seed) : random_(seed) {}

  /// One life of the daemon with up to five commands.
  void live() {
    const std::string point =
        kFailPoints[random_() % kFailPoints.size()] + std::string(":") + std::to_string(1 + random_() % 3);
    log_ += "\n-- a life until " + point;
    try {
      Daemon daemon(data_.path(), {}, point);
      Client client(daemon.url());
      do_pending(client);
      check_known(client);
      for (int command = 0; command < 4; ++command) {
        choose_command();
        do_pending(client);
      }
      daemon.ends_within(std::chrono::milliseconds(random_() % 60));
    } catch (const Unreachable&) {  // the daemon died; the pending command is sent again in the next life
      ++deaths_at_work_;
    } catch (const DaemonDied& death) {
      EXPECT_EQ(death.exit_code, -SIGKILL) << death.what();
      ++deaths_at_work_;
    }
    EXPECT_EQ(broken_promise(data_.path()), "") << log_;
  }

  /// Number of lives that ended at a fail point while a client waited for an answer or the daemon was
  /// starting.
  int deaths_at_work() const { return deaths_at_work_; }

  /// A last life without fail points: every study ends as it should.
  void end() {
    const Daemon daemon(data_.path());
    Client client(daemon.url());
    do_pending(client);
    check_known(client);
    for (auto& [study, known] : known_) client.post("/v1/studies/" + known.id + "/resume", "");
    for (const auto& [study, known] : known_)
      wait_for(client, "/v1/studies/" + known.id, [](const ordered_json& now) {
        return now["cases"]["queued"] == 0 && now["cases"]["running"] == 0;
      });
    check_ends(client);
    EXPECT_EQ(broken_promise(data_.path()), "") << log_;
  }

 private:
  struct Command {
    std::size_t study = 0;
    std::string change;  ///< empty: submit the study
    int priority = 0;
  };

  void choose_command() {
    const std::size_t study = random_() % kAxes.size();
    const bool is_known = known_.contains(study);
    const std::vector<std::string> changes = {"", "cancel", "pause", "resume", "retry", "priority"};
    pending_ = Command{study, is_known ? changes[random_() % changes.size()] : "",
                       static_cast<int>(random_() % 9) - 4};
    log_ += "\n" + (pending_->change.empty() ? "submit" : pending_->change) + " " + std::to_string(study);
  }

  /// Sends the pending command. Its effect is expected from then on only if the server answers.
  void do_pending(Client& client) {
    if (!pending_) return;
    const Command& command = *pending_;
    Known& known = known_[command.study];
    if (command.change.empty()) {
      const ordered_json answer = client.post(
          "/v1/studies", study_document("s" + std::to_string(command.study), kAxes[command.study]).dump());
      known.id = answer["id"];
      known.is_cancelled = known.is_paused = false;
    } else {
      client.post("/v1/studies/" + known.id + "/" + command.change,
                  command.change == "priority" ? json{{"priority", command.priority}}.dump() : "");
    }
    if (command.change == "cancel") known.is_cancelled = true;
    if (command.change == "pause" || command.change == "resume") known.is_paused = command.change == "pause";
    if (command.change == "priority") known.priority = command.priority;
    log_ += " -> answered";
    pending_.reset();
  }

  void check_known(Client& client) {
    for (const auto& [study, known] : known_) {
      if (known.id.empty()) continue;  // sent, but never answered
      const ordered_json now = client.get("/v1/studies/" + known.id);
      EXPECT_EQ(now["paused"], known.is_paused) << known.id << log_;
      EXPECT_EQ(now["cancelled"], known.is_cancelled) << known.id << log_;
      EXPECT_EQ(now["priority"], known.priority) << known.id << log_;
      EXPECT_EQ(now["cases"]["total"], kAxes[study]["Ca"].size() * kAxes[study]["V"].size())
          << known.id << log_;
    }
  }

  void check_ends(Client& client) {
    std::set<std::string> wanted;
    std::map<std::string, ordered_json> all;
    for (const auto& [study, known] : known_) {
      const ordered_json cases = client.get("/v1/studies/" + known.id + "/cases")["cases"];
      for (const ordered_json& shown : cases) {
        all[shown["id"]] = shown;
        if (!known.is_cancelled) wanted.insert(shown["id"].get<std::string>());
      }
    }
    for (const auto& [id, shown] : all) {
      const std::string end = state_that_ends(shown["parameters"]["V"]);
      const bool may_be_cancelled = !wanted.contains(id) && shown["state"] == "cancelled";
      EXPECT_TRUE(shown["state"] == end || may_be_cancelled) << shown.dump(2) << log_;
    }
  }

  TemporaryDirectory data_;
  std::mt19937 random_;
  std::map<std::size_t, Known> known_;
  std::optional<Command> pending_;
  std::string log_;
  int deaths_at_work_ = 0;
};

TEST(CommandHistory, AnsweredCommandsHoldWhicheverProcessIsKilled) {
  const int lives = number_from("CAPSTAN_LIVES", 60);
  const auto seed = static_cast<unsigned>(number_from("CAPSTAN_SEED", 1));
  CommandSequence sequence(seed);
  const int wanted_deaths = lives / 5;  // their number depends on the speed of the machine
  int lived = 0;
  for (; lived < lives || (sequence.deaths_at_work() < wanted_deaths && lived < 5 * lives); ++lived) {
    sequence.live();
    if (HasFailure()) return;
  }
  sequence.end();
  std::cout << lived << " lives, " << sequence.deaths_at_work()
            << " of them ended in the middle of a command\n";
  EXPECT_GE(sequence.deaths_at_work(), wanted_deaths);
}

}  // namespace
}  // namespace capstan
