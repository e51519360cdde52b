// What Slurm prints and takes: lists of tasks, times, needs; and the files that the daemon and a job share.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "runner/slurm/case_list.hpp"
#include "runner/slurm/job_request.hpp"
#include "runner/slurm/listed_task.hpp"
#include "runner/slurm/run_command.hpp"
#include "runner/slurm/slurm_words.hpp"
#include "runner/slurm/time_limit.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(Squeue, OtherJobsOfTheUserAreLeftOut) {
  const auto tasks = parse_squeue(
      "17_3|3|RUNNING|None|n2|capstan-a-1-x\n"
      "18|N/A|PENDING|Priority||my|own|job\n"
      "19_[4-9]|4-9|PENDING|Priority||capstan-b-1-y\n");
  ASSERT_TRUE(tasks);
  ASSERT_THAT(*tasks, SizeIs(1));
  EXPECT_EQ(tasks->front().job, "capstan-a-1-x");
  EXPECT_EQ(tasks->front().task, 3);
  EXPECT_EQ(tasks->front().node, "n2");
}

TEST(Squeue, LineOfAnotherFormMakesTheWholeAnswerInvalid) {
  EXPECT_FALSE(parse_squeue("17_3|3|RUNNING|None|n2|capstan-a-1-x\nslurm_load_jobs error\n"));
  EXPECT_TRUE(parse_squeue(""));
}

TEST(Squeue, StatesThatAreNotKnownCountAsActive) {
  EXPECT_TRUE((ListedTask{.state = "COMPLETING"}.is_active()));
  EXPECT_TRUE((ListedTask{.state = "SUSPENDED"}.is_active()));
  EXPECT_FALSE((ListedTask{.state = "NODE_FAIL"}.is_active()));
}

TEST(SlurmWords, SayAReasonThatHasNoWordsAsSlurmDoes) {
  EXPECT_EQ(why_it_waits({.reason = "Resources"}), "no node has enough free cores and memory");
  EXPECT_EQ(why_it_waits({.reason = "ReqNodeNotAvail, UnavailableNodes:n1"}),
            "nodes that it needs are down, drained or reserved");
  EXPECT_EQ(why_it_waits({.reason = "Nodes required for job are DOWN, DRAINED or reserved for jobs in higher "
                                    "priority partitions"}),
            "nodes that it needs are down, drained or reserved");
  EXPECT_EQ(why_it_waits({.reason = "QOSMaxJobsPerUserLimit"}),
            "a limit of its account or quality of service is reached (QOSMaxJobsPerUserLimit)");
  EXPECT_EQ(why_it_waits({.reason = "FancyReason"}), "(FancyReason)");
}

TEST(TimeLimit, IsReadInAllFormsOfSlurm) {
  EXPECT_EQ(parse_time_limit("90"), 90min);
  EXPECT_EQ(parse_time_limit("90:30"), 91min);
  EXPECT_EQ(parse_time_limit("1:30:00"), 90min);
  EXPECT_EQ(parse_time_limit("1-12"), 36h);
  EXPECT_EQ(parse_time_limit("1-12:30"), 36h + 30min);
  EXPECT_EQ(parse_time_limit("1-12:30:00"), 36h + 30min);
  for (const char* text : {"", "0", "an hour", "1:2:3:4", "-1", "1-", "10 min"})
    EXPECT_FALSE(parse_time_limit(text)) << text;
}

TEST(JobNeeds, HoldWhatIsExpectedWithAMarginAndAtMostTheGivenTime) {
  EXPECT_EQ(needs_of(1, 20e6, {}), (JobNeeds{256, 10min}));
  EXPECT_GE(needs_of(3600, 20e6, {}).time, 4h);
  EXPECT_GE(needs_of(1, 2e9, {}).memory_mb, 3000);
  EXPECT_EQ(needs_of(3600, 20e6, {.max_time = 60min}).time, 60min);
  EXPECT_EQ(needs_of(1, 20e6, {.memory_mb = 700}).memory_mb, 700);
}

TEST(CaseList, IsReadAsItWasWritten) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "0.list";
  write_case_list(file,
                  {{"t-1", "abc", RunDirectory("/a path/with spaces")}, {"t-2", "def", RunDirectory("/b")}});
  const auto cases = read_case_list(file);
  ASSERT_THAT(cases, SizeIs(2));
  EXPECT_EQ(cases[0].token, "t-1");
  EXPECT_EQ(cases[0].directory.path(), "/a path/with spaces");
  EXPECT_EQ(cases[1].case_id, "def");
}

TEST(Journal, TellsBeginningAndEndAndIgnoresAnIncompleteLine) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "0.journal";
  EXPECT_TRUE(read_journal(file).empty());
  note_beginning(file, "a");
  note_end(file, "a", {ProcessEnd::How::exited, 3});
  note_beginning(file, "b");
  note_end(file, "b", {ProcessEnd::How::signalled, SIGKILL});
  std::ofstream(file, std::ios::app) << "c exited 1";
  auto runs = read_journal(file);
  EXPECT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs["a"].end->number, 3);
  EXPECT_EQ(runs["b"].end->how, ProcessEnd::How::signalled);
}

TEST(RunCommand, ReturnsOutputErrorsAndExitCode) {
  const CommandOutcome outcome = run_command({"sh", "-c", "echo out; echo wrong >&2; exit 3"}, 10s);
  EXPECT_TRUE(outcome.is_finished);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.output, "out\n");
  EXPECT_EQ(outcome.errors, "wrong\n");
}

TEST(RunCommand, KillsACommandThatTakesTooLong) {
  const CommandOutcome outcome = run_command({"sh", "-c", "sleep 600 & wait"}, 50ms);
  EXPECT_FALSE(outcome.is_finished);
  EXPECT_THAT(outcome.errors, HasSubstr("did not end within"));
}

TEST(RunCommand, KeepsCapstansVariablesFromTheCommand) {
  setenv("CAPSTAN_TOKEN", "secret", 1);
  EXPECT_EQ(run_command({"sh", "-c", "echo $CAPSTAN_TOKEN"}, 10s).output, "\n");
  unsetenv("CAPSTAN_TOKEN");
}

TEST(RunCommand, SaysThatThereIsNoSuchCommand) {
  const CommandOutcome outcome = run_command({"no-such-command"}, 10s);
  EXPECT_FALSE(outcome.is_success());
  EXPECT_THAT(outcome.errors, HasSubstr("no-such-command: No such file"));
}

}  // namespace
}  // namespace capstan
