// The executor with fake commands of Slurm: what is asked for, and what becomes of the runs when Slurm fails.
#include "runner/slurm/slurm_executor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "solver/case/content_id.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_slurm.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class SlurmExecutorTest : public ::testing::Test {
 protected:
  void SetUp() override { executor_ = make_executor(); }

  /// One that Slurm has answered.
  std::unique_ptr<SlurmExecutor> make_executor() {
    auto executor = std::make_unique<SlurmExecutor>(settings_, runs_.path(), clock_);
    executor->exchange();
    return executor;
  }

  /// Starts a run of a case of its own.
  RunHandle start(double kt = 30, const std::string& fidelity = "fast") {
    const double Ca = 0.1 + 0.01 * ++count_;
    nlohmann::json document = study_document("study", {{"Ca", {Ca}}});
    document["base"]["until"]["kt"] = kt;
    document["base"]["fidelity"] = fidelity;
    const Case c = parse_study(document).value->cases[0];
    const auto [id, text] = canonical(c);
    claims_.push_back({id, text, "token" + std::to_string(count_), 1, ""});
    Claim& claim = claims_.back();
    const RunDirectory directory(runs_.path() / id);
    directory.prepare(text);
    directory.begin_attempt(claim.token);
    claim.handle = executor_->start(claim, directory);
    return claim.handle;
  }
  /// Two seconds later, when squeue is called again.
  void exchange() {
    clock_.advance(2s);
    executor_->exchange();
  }
  void submit() { executor_->exchange(); }

  const Claim& claim_of(const RunHandle& run) const {
    return *std::find_if(claims_.begin(), claims_.end(), [&](const Claim& c) { return c.handle == run; });
  }
  RunDirectory directory_of(const RunHandle& run) const {
    return RunDirectory(runs_.path() / claim_of(run).case_id);
  }
  std::string name_of_job(const RunHandle& first) const {
    return "capstan-" + claim_of(first).case_id + "-1-" + claim_of(first).token;
  }
  JobDirectory job_of(const RunHandle& first) const {
    return JobDirectory(runs_.path() / "jobs" / name_of_job(first));
  }
  /// squeue lists the first task of the job in this state.
  void list(const RunHandle& first, const std::string& state, const std::string& reason = "None") {
    const std::string node = state == "PENDING" ? "" : "n1";
    slurm_.answer("squeue", "17_0|0|" + state + "|" + reason + "|" + node + "|" + name_of_job(first) + "\n");
  }
  void begin(const RunHandle& run) { note_beginning(job_of(run).journal(0), claim_of(run).token); }

  FakeSlurm slurm_;
  TemporaryDirectory runs_;
  FakeClock clock_;
  SlurmSettings settings_{.program = "/opt/capstan", .jobs = 4};
  std::unique_ptr<SlurmExecutor> executor_;
  std::vector<Claim> claims_;
  int count_ = 0;
};

TEST_F(SlurmExecutorTest, RunsStartedTogetherAreOneJobArrayNamedByTheFirst) {
  const RunHandle first = start();
  start();
  submit();
  ASSERT_THAT(slurm_.calls("sbatch"), SizeIs(1));
  EXPECT_THAT(slurm_.calls("sbatch")[0],
              AllOf(HasSubstr("--job-name=" + name_of_job(first)), HasSubstr("--array=0-1"),
                    HasSubstr("--signal=B:USR1@120"), HasSubstr("--no-requeue")));
}

TEST_F(SlurmExecutorTest, ListsAreWrittenBeforeSbatchIsCalled) {
  const RunHandle run = start();
  submit();
  EXPECT_EQ(slurm_.submitted_lists(),
            "token1 " + claim_of(run).case_id + " " +
                (std::filesystem::canonical(runs_.path()) / claim_of(run).case_id).string() + "\n");
}

TEST_F(SlurmExecutorTest, LongRunsAskForMoreTimeInAnArrayOfTheirOwn) {
  start(1);
  start(1000, "fine");
  submit();
  const auto calls = slurm_.calls("sbatch");
  ASSERT_THAT(calls, SizeIs(2));
  EXPECT_THAT(calls[0], HasSubstr("--time=10 "));
  EXPECT_THAT(calls[1], Not(HasSubstr("--time=10 ")));
}

TEST_F(SlurmExecutorTest, PassesOnPartitionAccountAndFurtherArguments) {
  settings_.partition = "main";
  settings_.account = "flow";
  settings_.extra = {"--qos=low", "--nice"};
  executor_ = make_executor();
  start();
  submit();
  EXPECT_THAT(slurm_.calls("sbatch")[0], HasSubstr("--partition=main --account=flow --qos=low --nice "));
}

TEST_F(SlurmExecutorTest, ShortCasesShareAJobWhenManyWait) {
  std::vector<RunHandle> runs;
  while (executor_->has_room(0, 80)) runs.push_back(start(1));
  EXPECT_THAT(runs, SizeIs(40)) << "half of the waiting cases, on four jobs";
  submit();
  EXPECT_THAT(slurm_.calls("sbatch")[0], HasSubstr("--array=0-3"));
}

TEST_F(SlurmExecutorTest, HasRoomForAsManyJobsAsWereAskedFor) {
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(executor_->has_room(0, 4));
    start();
  }
  EXPECT_FALSE(executor_->has_room(0, 4));
  submit();
  EXPECT_FALSE(executor_->has_room(0, 4));
}

TEST_F(SlurmExecutorTest, EndOfARunIsTheOneThatItsJobNoted) {
  const RunHandle run = start();
  submit();
  list(run, "RUNNING");
  begin(run);
  exchange();
  EXPECT_FALSE(executor_->poll(run));
  note_end(job_of(run).journal(0), claim_of(run).token, {ProcessEnd::How::exited, 75});
  exchange();
  const auto end = executor_->poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::exited);
  EXPECT_EQ(end->number, 75);
}

TEST_F(SlurmExecutorTest, JobThatWasSubmittedAlthoughSbatchTimedOutIsFoundByItsName) {
  slurm_.fail("sbatch", "sbatch: error: Batch job submission failed: Socket timed out");
  const RunHandle run = start();
  submit();
  list(run, "PENDING", "Priority");
  for (int i = 0; i < 5; ++i) exchange();
  EXPECT_FALSE(executor_->poll(run));
  EXPECT_THAT(slurm_.calls("sbatch"), SizeIs(1));
}

TEST_F(SlurmExecutorTest, RunsOfAJobThatWasRefusedHaveNotBegunAndSayWhy) {
  slurm_.fail("sbatch", "sbatch: error: invalid partition specified: mian");
  const RunHandle run = start();
  submit();
  EXPECT_THAT(executor_->obstacle(), HasSubstr("invalid partition"));
  EXPECT_FALSE(executor_->has_room(0, 1));
  slurm_.answer("squeue", "");
  exchange();
  EXPECT_FALSE(executor_->poll(run)) << "it may be listed a moment later";
  exchange();
  const auto end = executor_->poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::not_begun);
  EXPECT_THAT(end->reason, HasSubstr("invalid partition"));
  clock_.advance(10s);
  EXPECT_TRUE(executor_->has_room(0, 1)) << "it is tried again later";
}

TEST_F(SlurmExecutorTest, JobsThatFailBeforeTheirFirstCaseAreNotRepeatedAtOnce) {
  const RunHandle run = start();
  submit();
  list(run, "FAILED", "NonZeroExitCode");
  exchange();
  exchange();
  const auto end = executor_->poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::not_begun);
  EXPECT_FALSE(executor_->has_room(0, 1));
  executor_->exchange();
  EXPECT_THAT(executor_->obstacle(), HasSubstr("fail before their first case"));
  clock_.advance(10s);
  EXPECT_TRUE(executor_->has_room(0, 1)) << "it is tried again later";
}

TEST_F(SlurmExecutorTest, WhileTheControllerIsDownRunsGoOnAndNoneIsStarted) {
  const RunHandle run = start();
  submit();
  slurm_.fail("squeue", "slurm_load_jobs error: Unable to contact slurm controller (connect failure)");
  for (int i = 0; i < 5; ++i) exchange();
  EXPECT_FALSE(executor_->poll(run));
  EXPECT_FALSE(executor_->has_room(0, 1));
  EXPECT_THAT(executor_->obstacle(), HasSubstr("Unable to contact slurm controller"));
  EXPECT_THAT(executor_->metrics(), HasSubstr("capstan_slurm_up 0"));
  list(run, "RUNNING");
  exchange();
  EXPECT_FALSE(executor_->poll(run));
  EXPECT_EQ(executor_->obstacle(), "");
}

TEST_F(SlurmExecutorTest, NothingIsStartedBeforeSlurmHasAnswered) {
  slurm_.fail("squeue", "squeue: command not found");
  executor_ = make_executor();
  EXPECT_FALSE(executor_->has_room(0, 1));
  EXPECT_THAT(executor_->obstacle(), HasSubstr("command not found"));
}

TEST_F(SlurmExecutorTest, AnswerThatIsNotUnderstoodChangesNothing) {
  const RunHandle run = start();
  submit();
  slurm_.answer("squeue", "Good morning. The cluster is down for maintenance.\n");
  for (int i = 0; i < 5; ++i) exchange();
  EXPECT_FALSE(executor_->poll(run));
  EXPECT_THAT(executor_->obstacle(), HasSubstr("Good morning"));
}

TEST_F(SlurmExecutorTest, JobThatTheControllerForgotIsQueuedAgainAndPublishesNothing) {
  const RunHandle run = start();
  submit();
  list(run, "PENDING", "Resources");
  exchange();
  slurm_.answer("squeue", "");
  exchange();
  exchange();
  const auto end = executor_->poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::not_begun);
  EXPECT_EQ(end->reason, "Slurm does not know its job any more");
  EXPECT_FALSE(directory_of(run).is_attempt("token1"));
}

TEST_F(SlurmExecutorTest, PreemptionAndNodeFailureInterruptARunAndAreNoCrash) {
  for (const std::string state : {"PREEMPTED", "NODE_FAIL", "TIMEOUT", "CANCELLED"}) {
    const RunHandle run = start();
    submit();
    begin(run);
    list(run, state);
    exchange();
    exchange();
    const auto end = executor_->poll(run);
    ASSERT_TRUE(end) << state;
    EXPECT_EQ(end->how, ProcessEnd::How::lost) << state;
    EXPECT_THAT(end->reason, HasSubstr("job 17_0 on node n1")) << state;
  }
}

TEST_F(SlurmExecutorTest, RunOverItsMemoryCountsAsACrash) {
  const RunHandle run = start();
  submit();
  begin(run);
  list(run, "OUT_OF_MEMORY");
  exchange();
  exchange();
  const auto end = executor_->poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::exited);
  EXPECT_EQ(run_ending_of(end->number), RunEnding::crashed);
  EXPECT_THAT(end->reason, HasSubstr("more memory"));
}

TEST_F(SlurmExecutorTest, CancelledRunEndsAtOnceAndItsJobIsCancelled) {
  const RunHandle run = start();
  submit();
  list(run, "PENDING", "Priority");
  exchange();
  executor_->cancel(run, StopBy::checkpoint);
  EXPECT_TRUE(executor_->poll(run));
  EXPECT_FALSE(directory_of(run).is_attempt("token1"));
  exchange();
  EXPECT_THAT(slurm_.calls("scancel"), ElementsAre("17_0 "));
}

TEST_F(SlurmExecutorTest, CancellationOfOneCaseLeavesTheOthersOfItsJob) {
  executor_->has_room(0, 80);
  const RunHandle first = start(1), second = start(1);
  submit();
  list(first, "RUNNING");
  exchange();
  executor_->cancel(first, StopBy::checkpoint);
  exchange();
  EXPECT_THAT(slurm_.calls("scancel"), IsEmpty());
  EXPECT_FALSE(executor_->poll(second));
}

TEST_F(SlurmExecutorTest, RunThatIsCancelledBeforeItsSubmissionIsNotSubmitted) {
  const RunHandle run = start();
  executor_->cancel(run, StopBy::checkpoint);
  submit();
  EXPECT_TRUE(executor_->poll(run));
  EXPECT_THAT(slurm_.calls("sbatch"), IsEmpty());
}

TEST_F(SlurmExecutorTest, SuccessorFindsTheRunsOfAnEarlierDaemon) {
  const RunHandle first = start(), second = start();
  submit();
  list(first, "RUNNING");
  executor_ = make_executor();
  EXPECT_TRUE(executor_->adopt(claim_of(first), directory_of(first)));
  begin(first);
  exchange();
  EXPECT_FALSE(executor_->poll(first));
  EXPECT_EQ(executor_->place(first).details, "Slurm's job 17_0 on node n1");
  EXPECT_FALSE(executor_->adopt({"", "", "unknown", 1, "slurm:unknown"}, directory_of(second)));
}

TEST_F(SlurmExecutorTest, SaysWhereARunIsAndWhatItWaitsFor) {
  const RunHandle run = start();
  EXPECT_TRUE(executor_->place(run).is_waiting);
  submit();
  list(run, "PENDING", "Priority");
  exchange();
  EXPECT_EQ(executor_->place(run).details,
            "waits as job 17_0 in Slurm's queue: jobs of higher priority are before it");
  EXPECT_THAT(executor_->metrics(), HasSubstr("capstan_slurm_jobs{state=\"PENDING\",reason=\"Priority\"} 1"));
}

TEST_F(SlurmExecutorTest, FilesOfAJobAreRemovedWhenItHasEnded) {
  const RunHandle run = start();
  submit();
  list(run, "RUNNING");
  begin(run);
  note_end(job_of(run).journal(0), claim_of(run).token, {ProcessEnd::How::exited, 0});
  exchange();
  EXPECT_TRUE(executor_->poll(run));
  exchange();
  EXPECT_TRUE(std::filesystem::exists(job_of(run).path())) << "the job still runs";
  list(run, "COMPLETED");
  exchange();
  EXPECT_FALSE(std::filesystem::exists(job_of(run).path()));
}

}  // namespace
}  // namespace capstan
