#include "runner/queue/job_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "runner/daemon/replacement.hpp"
#include "tests/support/queue_fixture.hpp"

namespace capstan {
namespace {

using namespace std::chrono_literals;

class JobQueueTest : public QueueFixture {};

TEST_F(JobQueueTest, CasesAreClaimedInTheOrderOfSubmission) {
  submit(two_cases_);
  const auto first = queue_.claim();
  const auto second = queue_.claim();
  EXPECT_EQ(nlohmann::json::parse(first->document)["Ca"], 0.25);
  EXPECT_EQ(nlohmann::json::parse(second->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
  EXPECT_EQ(first->attempt, 1);
  EXPECT_NE(first->token, second->token);
}

/// PRAGMA synchronous remains as the last transaction set it; 2 is FULL.
TEST_F(JobQueueTest, AnsweredChangesAreSyncedAndLeasesAreNot) {
  const auto is_synced = [&] {
    Statement row = database_.query("PRAGMA synchronous");
    return row.step() && row.integer(0) == 2;
  };
  const std::string id = submit(two_cases_).study_id;
  EXPECT_TRUE(is_synced());
  const auto claim = queue_.claim();
  EXPECT_FALSE(is_synced());
  queue_.end(*claim, RunEnding::done, "");
  EXPECT_TRUE(is_synced());
  for (const auto& change : std::vector<std::function<void()>>{
           [&] { queue_.cancel(id); }, [&] { queue_.pause(id, true); }, [&] { queue_.retry(id); },
           [&] { queue_.set_priority(id, 3); }, [&] { submit(two_cases_); }}) {
    queue_.renew(*claim);
    EXPECT_FALSE(is_synced());
    change();
    EXPECT_TRUE(is_synced());
  }
}

TEST_F(JobQueueTest, FinishedCaseIsNeverClaimedAgain) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.end(*claim, RunEnding::done, ""));
  EXPECT_EQ(state_of(claim->case_id), "done");
  clock_.advance(24h);
  queue_.give_back_expired();
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, RenewedLeaseDoesNotExpire) {
  submit(two_cases_);
  const auto claim = queue_.claim();
  for (int beat = 0; beat < 20; ++beat) {
    clock_.advance(queue_.heartbeat());
    EXPECT_TRUE(queue_.renew(*claim));
    EXPECT_EQ(queue_.give_back_expired(), 0);
  }
}

TEST_F(JobQueueTest, HolderOfAnExpiredLeaseRecordsNothing) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto late = queue_.claim();
  clock_.advance(JobQueue::kLease + 1ms);
  EXPECT_EQ(queue_.give_back_expired(), 1);
  const auto next = queue_.claim();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->case_id, late->case_id);
  EXPECT_EQ(next->attempt, 2);
  EXPECT_FALSE(queue_.renew(*late));
  EXPECT_FALSE(queue_.end(*late, RunEnding::failed, "too late"));
  EXPECT_FALSE(queue_.end(*late, RunEnding::crashed, "too late"));
  EXPECT_EQ(state_of(next->case_id), "running");
  EXPECT_TRUE(queue_.end(*next, RunEnding::done, ""));
}

TEST_F(JobQueueTest, ExpiredLeaseOfASupervisedRunIsRenewed) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  clock_.jump(24h);
  EXPECT_EQ(queue_.give_back_expired([&](const Claim& held) { return held.token == claim->token; }), 0);
  EXPECT_EQ(queue_.give_back_expired(), 0);
  EXPECT_TRUE(queue_.renew(*claim));
}

TEST_F(JobQueueTest, ResultIsRecordedOnce) {
  submit(two_cases_);
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.end(*claim, RunEnding::done, ""));
  EXPECT_FALSE(queue_.end(*claim, RunEnding::failed, "again"));
  EXPECT_EQ(state_of(claim->case_id), "done");
}

TEST_F(JobQueueTest, InterruptionsDoNotCountAsCrashes) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  for (int time = 0; time < 5; ++time)
    EXPECT_TRUE(queue_.end(*queue_.claim(), RunEnding::interrupted, "power cut"));
  EXPECT_TRUE(queue_.claim());
}

TEST_F(JobQueueTest, SecondCrashFailsTheCaseAndKeepsTheReason) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  queue_.end(*claim, RunEnding::crashed, "killed by signal 9");
  EXPECT_EQ(state_of(claim->case_id), "queued");
  clock_.advance(JobQueue::kBackOff);
  queue_.end(*queue_.claim(), RunEnding::crashed, "killed by signal 11");
  EXPECT_EQ(state_of(claim->case_id), "failed");
  EXPECT_EQ(message_of(claim->case_id), "killed by signal 11");
  EXPECT_EQ(count("attempts"), 2);
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, CancellationTakesQueuedCasesAtOnceAndIsRequestedForRunningOnes) {
  const std::string id = submit(two_cases_).study_id;
  const auto running = queue_.claim();
  EXPECT_FALSE(queue_.to_be_cancelled().contains(running->token));
  EXPECT_TRUE(queue_.cancel(id));
  EXPECT_FALSE(queue_.claim());
  EXPECT_TRUE(queue_.to_be_cancelled().contains(running->token));
  EXPECT_TRUE(queue_.end(*running, RunEnding::interrupted, "asked to"));
  EXPECT_EQ(state_of(running->case_id), "cancelled");
  EXPECT_EQ(last_ending_of(running->case_id), "interrupted");
}

TEST_F(JobQueueTest, CaseThatAnotherStudyWantsIsNotCancelled) {
  const std::string id = submit(two_cases_).study_id;
  submit(sample_study("other", {{"Ca", {0.75}}}));
  queue_.cancel(id);
  const auto claim = queue_.claim();
  ASSERT_TRUE(claim);
  EXPECT_EQ(nlohmann::json::parse(claim->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, RunThatCompletesInSpiteOfACancellationKeepsItsAnswer) {
  const std::string id = submit(two_cases_).study_id;
  const auto running = queue_.claim();
  queue_.cancel(id);
  EXPECT_TRUE(queue_.end(*running, RunEnding::done, ""));
  EXPECT_EQ(state_of(running->case_id), "done");
}

TEST_F(JobQueueTest, UnknownStudyCannotBeCancelled) { EXPECT_FALSE(queue_.cancel("nobody-0000")); }

TEST_F(JobQueueTest, RunningClaimsAreFoundAgainWithTheirHandles) {
  submit(two_cases_);
  const auto claim = queue_.claim();
  queue_.started(*claim, "process 42");
  const auto found = queue_.running();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].case_id, claim->case_id);
  EXPECT_EQ(found[0].token, claim->token);
  EXPECT_EQ(found[0].handle, "process 42");
}

TEST_F(JobQueueTest, CrashedCaseWaitsForItsBackOffWhileOthersAreStarted) {
  submit(two_cases_);
  const auto crashed = queue_.claim();
  queue_.end(*crashed, RunEnding::crashed, "killed by signal 9");
  const auto other = queue_.claim();
  ASSERT_TRUE(other);
  EXPECT_NE(other->case_id, crashed->case_id);
  EXPECT_FALSE(queue_.claim());
  clock_.advance(JobQueue::kBackOff);
  EXPECT_EQ(queue_.claim()->case_id, crashed->case_id);
}

TEST_F(JobQueueTest, BackOffEndsAlsoIfTheClockWasSetBack) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  queue_.end(*queue_.claim(), RunEnding::crashed, "killed by signal 9");
  EXPECT_FALSE(queue_.claim());
  clock_.jump(-24h);
  EXPECT_TRUE(queue_.claim());
}

TEST_F(JobQueueTest, RunThatCouldNotBeStartedIsNoAttemptAndWaits) {
  submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.put_back(*claim, "no memory"));
  EXPECT_FALSE(queue_.put_back(*claim, "no memory"));
  EXPECT_EQ(count("attempts"), 0);
  EXPECT_FALSE(queue_.claim());
  clock_.advance(JobQueue::kBackOff);
  EXPECT_EQ(queue_.claim()->attempt, 1);
}

TEST_F(JobQueueTest, StudiesOfOnePriorityTakeTurns) {
  submit(sample_study("first", {{"Ca", {0.1, 0.2, 0.3}}}));
  submit(sample_study("second", {{"Ca", {0.4, 0.5}}}));
  std::vector<double> order;
  while (const auto claim = queue_.claim()) order.push_back(nlohmann::json::parse(claim->document)["Ca"]);
  EXPECT_THAT(order, ::testing::ElementsAre(0.1, 0.4, 0.2, 0.5, 0.3));
}

TEST_F(JobQueueTest, HigherPriorityGoesFirst) {
  submit(sample_study("first", {{"Ca", {0.1}}}));
  EXPECT_TRUE(queue_.set_priority(submit(sample_study("urgent", {{"Ca", {0.4}}})).study_id, 1));
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.4);
  EXPECT_FALSE(queue_.set_priority("nobody-0000", 1));
}

TEST_F(JobQueueTest, PausedStudyStartsNothingUnlessAnotherWantsIt) {
  const std::string id = submit(two_cases_).study_id;
  EXPECT_TRUE(queue_.pause(id, true));
  EXPECT_FALSE(queue_.claim());
  submit(sample_study("other", {{"Ca", {0.75}}}));
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
  queue_.pause(id, false);
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.25);
}

TEST_F(JobQueueTest, RetryQueuesOnlyFailedCases) {
  const std::string id = submit(two_cases_).study_id;
  const auto failed = queue_.claim();
  queue_.end(*failed, RunEnding::failed, "no memory");
  queue_.end(*queue_.claim(), RunEnding::diverged, "it tore");
  EXPECT_TRUE(queue_.retry(id));
  EXPECT_EQ(queue_.claim()->case_id, failed->case_id);
  EXPECT_FALSE(queue_.claim());
  EXPECT_FALSE(queue_.retry("nobody-0000"));
}

TEST_F(JobQueueTest, RetryOfACancelledStudyQueuesNothing) {
  const std::string id = submit(two_cases_).study_id;
  const auto failed = queue_.claim();
  queue_.end(*failed, RunEnding::failed, "no memory");
  queue_.cancel(id);
  EXPECT_TRUE(queue_.retry(id));
  EXPECT_EQ(state_of(failed->case_id), "failed");
  EXPECT_TRUE(replace_failed(database_, id, "fine").empty());
  EXPECT_EQ(count("cases"), 2);
}

}  // namespace
}  // namespace capstan
