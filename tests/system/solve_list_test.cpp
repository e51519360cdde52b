// What a job of a cluster does, without a cluster, and with the fake solver.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner/slurm/case_list.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/wait_until.hpp"

namespace capstan {
namespace {

class SolveList : public ::testing::Test {
 protected:
  /// V as the fake solver takes it.
  ListedCase add_case(const std::string& id, int V) {
    const RunDirectory directory(parent_.path() / id);
    directory.prepare(R"({"V": )" + std::to_string(V) +
                      R"(, "Ca": 0.25, "until": {"kt": 30}, "fidelity": {"nodes": 642}})");
    directory.begin_attempt(id);
    cases_.push_back({id, id, directory});
    return cases_.back();
  }
  /// Starts a job. Returns its process id.
  pid_t start() {
    write_case_list(list_, cases_);
    const pid_t pid = fork();
    if (pid == 0) {
      execl(CAPSTAN_PROGRAM, "capstan", "solve-list", list_.c_str(), "--journal", journal_.c_str(), nullptr);
      std::_Exit(127);
    }
    return pid;
  }
  static int exit_code_of(pid_t job) {
    int status = 0;
    waitpid(job, &status, 0);
    return WEXITSTATUS(status);
  }
  bool has_begun(const std::string& token) { return read_journal(journal_)[token].has_begun; }

  TemporaryDirectory parent_;
  std::filesystem::path list_ = parent_.path() / "0.list", journal_ = parent_.path() / "0.journal";
  std::vector<ListedCase> cases_;
};

TEST_F(SolveList, ComputesItsCasesAndNotesHowEachEnded) {
  const ListedCase first = add_case("1", 4), second = add_case("2", 50), third = add_case("3", 4);
  EXPECT_EQ(exit_code_of(start()), 0);
  auto runs = read_journal(journal_);
  EXPECT_EQ(runs["1"].end->number, 0);
  EXPECT_EQ(runs["2"].end->number, 3);
  EXPECT_EQ(runs["3"].end->number, 0);
  EXPECT_TRUE(third.directory.result());
}

TEST_F(SolveList, PassesOverCasesOfOtherAttempts) {
  const ListedCase taken = add_case("1", 4);
  taken.directory.begin_attempt("of another job");
  EXPECT_EQ(exit_code_of(start()), 0);
  EXPECT_FALSE(taken.directory.result());
  EXPECT_TRUE(read_journal(journal_).empty());
}

TEST_F(SolveList, WritesACheckpointAndStopsWhenItsTimeIsOver) {
  add_case("1", 70);
  const ListedCase later = add_case("2", 4);
  const pid_t job = start();
  ASSERT_TRUE(wait_until([&] { return has_begun("1"); }));
  kill(job, SIGUSR1);
  EXPECT_EQ(exit_code_of(job), 75);
  EXPECT_EQ(read_journal(journal_)["1"].end->number, 75);
  EXPECT_FALSE(later.directory.result());
}

TEST_F(SolveList, OfATaskThatWasStartedTwiceOnlyTheSecondPublishes) {
  const ListedCase listed = add_case("1", 40);
  const pid_t first = start();
  ASSERT_TRUE(wait_until([&] { return has_begun("1"); }));
  const std::string token_of_first = file_bytes(listed.directory.attempt_file());
  const pid_t second = start();
  ASSERT_TRUE(wait_until([&] { return file_bytes(listed.directory.attempt_file()) != token_of_first; }));
  std::ofstream(listed.directory.path() / "go").flush();
  EXPECT_EQ(exit_code_of(first), 0);
  EXPECT_FALSE(read_journal(journal_)["1"].end && !listed.directory.result())
      << "the first published nothing";
  EXPECT_EQ(exit_code_of(second), 0);
  EXPECT_TRUE(listed.directory.result());
  EXPECT_EQ(read_journal(journal_)["1"].end->number, 0);
}

}  // namespace
}  // namespace capstan
