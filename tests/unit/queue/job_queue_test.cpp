#include "runner/queue/job_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "runner/queue/points.hpp"
#include "runner/queue/replacement.hpp"
#include "runner/recording/result.hpp"
#include "runner/store/schema.hpp"
#include "solver/case/content_id.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using testing::MatchesRegex;
using namespace std::chrono_literals;

class JobQueueTest : public testing::Test {
 protected:
  std::string state_of(const std::string& case_id) {
    return text("SELECT state FROM cases WHERE id = ?", case_id);
  }
  std::string message_of(const std::string& case_id) {
    return text("SELECT message FROM cases WHERE id = ?", case_id);
  }
  std::string last_ending_of(const std::string& case_id) {
    return text("SELECT ending FROM attempts WHERE case_id = ? ORDER BY attempt DESC", case_id);
  }
  std::string text(const char* sql, const std::string& value) {
    Statement row = database_.query(sql, value);
    return row.step() ? row.text(0) : "nothing";
  }
  std::int64_t count(const char* table) {
    Statement row = database_.query(std::string("SELECT count(*) FROM ") + table);
    row.step();
    return row.integer(0);
  }

  TemporaryDirectory directory_;
  FakeClock clock_;
  Database database_{directory_.path() / "queue.sqlite", Database::Access::write};
  JobQueue queue_{database_, clock_};
  Study two_cases_ = sample_study("two", {{"Ca", {0.25, 0.75}}});
};

TEST_F(JobQueueTest, StudyIdIsItsNameInSmallLettersAndFourDigits) {
  EXPECT_THAT(queue_.submit(sample_study("Fig16a", {{"Ca", {0.1}}})).study_id,
              MatchesRegex("fig16a-[0-9a-f]{4}"));
}

TEST_F(JobQueueTest, SameStudyAgainIsTheSameStudyAndCostsNothing) {
  const Submission first = queue_.submit(two_cases_);
  const Submission second = queue_.submit(two_cases_);
  EXPECT_TRUE(first.is_new);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(first.study_id, second.study_id);
  EXPECT_EQ(count("cases"), 2);
}

TEST_F(JobQueueTest, CaseOfTwoStudiesIsComputedOnce) {
  queue_.submit(two_cases_);
  queue_.submit(sample_study("other", {{"Ca", {0.75, 1.0}}}));
  EXPECT_EQ(count("cases"), 3);
  EXPECT_EQ(count("study_cases"), 4);
}

TEST_F(JobQueueTest, StudiesOfOneNameHaveDifferentIds) {
  const std::string first = queue_.submit(two_cases_).study_id;
  EXPECT_NE(queue_.submit(sample_study("two", {{"Ca", {0.25}}})).study_id, first);
}

TEST_F(JobQueueTest, CasesAreClaimedInTheOrderOfSubmission) {
  queue_.submit(two_cases_);
  const auto first = queue_.claim();
  const auto second = queue_.claim();
  EXPECT_EQ(nlohmann::json::parse(first->document)["Ca"], 0.25);
  EXPECT_EQ(nlohmann::json::parse(second->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
  EXPECT_EQ(first->attempt, 1);
  EXPECT_NE(first->token, second->token);
}

/// The writer's last transaction shows how it was committed; 2 is FULL.
TEST_F(JobQueueTest, PromisesWaitForTheDiskAndLeasesDoNot) {
  const auto is_synced = [&] {
    Statement row = database_.query("PRAGMA synchronous");
    return row.step() && row.integer(0) == 2;
  };
  const std::string id = queue_.submit(two_cases_).study_id;
  EXPECT_TRUE(is_synced());
  const auto claim = queue_.claim();
  EXPECT_FALSE(is_synced());
  queue_.end(*claim, RunEnding::done, "");
  EXPECT_TRUE(is_synced());
  for (const auto& change : std::vector<std::function<void()>>{
           [&] { queue_.cancel(id); }, [&] { queue_.pause(id, true); }, [&] { queue_.retry(id); },
           [&] { queue_.set_priority(id, 3); }, [&] { queue_.submit(two_cases_); }}) {
    queue_.renew(*claim);
    EXPECT_FALSE(is_synced());
    change();
    EXPECT_TRUE(is_synced());
  }
}

TEST_F(JobQueueTest, FinishedCaseIsNeverClaimedAgain) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.end(*claim, RunEnding::done, ""));
  EXPECT_EQ(state_of(claim->case_id), "done");
  clock_.advance(24h);
  queue_.give_back_expired();
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, RenewedLeaseDoesNotExpire) {
  queue_.submit(two_cases_);
  const auto claim = queue_.claim();
  for (int beat = 0; beat < 20; ++beat) {
    clock_.advance(queue_.heartbeat());
    EXPECT_TRUE(queue_.renew(*claim));
    EXPECT_EQ(queue_.give_back_expired(), 0);
  }
}

TEST_F(JobQueueTest, ExpiredLeaseGivesTheCaseToTheNextAndNotToTheLate) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
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

TEST_F(JobQueueTest, ExpiredLeaseOfARunThatIsKnownIsRenewed) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  clock_.jump(24h);
  EXPECT_EQ(queue_.give_back_expired([&](const Claim& held) { return held.token == claim->token; }), 0);
  EXPECT_EQ(queue_.give_back_expired(), 0);
  EXPECT_TRUE(queue_.renew(*claim));
}

TEST_F(JobQueueTest, ResultIsRecordedOnce) {
  queue_.submit(two_cases_);
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.end(*claim, RunEnding::done, ""));
  EXPECT_FALSE(queue_.end(*claim, RunEnding::failed, "again"));
  EXPECT_EQ(state_of(claim->case_id), "done");
}

TEST_F(JobQueueTest, InterruptionIsNoCrash) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
  for (int time = 0; time < 5; ++time)
    EXPECT_TRUE(queue_.end(*queue_.claim(), RunEnding::interrupted, "power cut"));
  EXPECT_TRUE(queue_.claim());
}

TEST_F(JobQueueTest, SecondCrashFailsTheCaseAndKeepsTheReason) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
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

TEST_F(JobQueueTest, CancelledStudyLeavesTheQueueAtOnceAndItsRunsAreMarked) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const auto running = queue_.claim();
  EXPECT_FALSE(queue_.is_to_be_cancelled(*running));
  EXPECT_TRUE(queue_.cancel(id));
  EXPECT_FALSE(queue_.claim());
  EXPECT_TRUE(queue_.is_to_be_cancelled(*running));
  EXPECT_TRUE(queue_.end(*running, RunEnding::interrupted, "asked to"));
  EXPECT_EQ(state_of(running->case_id), "cancelled");
  EXPECT_EQ(last_ending_of(running->case_id), "interrupted");
}

TEST_F(JobQueueTest, CaseThatAnotherStudyWantsIsNotCancelled) {
  const std::string id = queue_.submit(two_cases_).study_id;
  queue_.submit(sample_study("other", {{"Ca", {0.75}}}));
  queue_.cancel(id);
  const auto claim = queue_.claim();
  ASSERT_TRUE(claim);
  EXPECT_EQ(nlohmann::json::parse(claim->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, CancelledStudyThatIsSubmittedAgainIsQueuedAgain) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const auto running = queue_.claim();
  queue_.cancel(id);
  queue_.submit(two_cases_);
  EXPECT_FALSE(queue_.is_to_be_cancelled(*running));
  EXPECT_TRUE(queue_.claim());
}

TEST_F(JobQueueTest, RunThatCompletesInSpiteOfACancellationKeepsItsAnswer) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const auto running = queue_.claim();
  queue_.cancel(id);
  EXPECT_TRUE(queue_.end(*running, RunEnding::done, ""));
  EXPECT_EQ(state_of(running->case_id), "done");
}

TEST_F(JobQueueTest, UnknownStudyCannotBeCancelled) { EXPECT_FALSE(queue_.cancel("nobody-0000")); }

TEST_F(JobQueueTest, RunningClaimsAreFoundAgainWithTheirHandles) {
  queue_.submit(two_cases_);
  const auto claim = queue_.claim();
  queue_.started(*claim, "process 42");
  const auto found = queue_.running();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].case_id, claim->case_id);
  EXPECT_EQ(found[0].token, claim->token);
  EXPECT_EQ(found[0].handle, "process 42");
}

TEST_F(JobQueueTest, CrashedCaseIsNotTriedAgainAtOnceAndHoldsNobodyUp) {
  queue_.submit(two_cases_);
  const auto crashed = queue_.claim();
  queue_.end(*crashed, RunEnding::crashed, "killed by signal 9");
  const auto other = queue_.claim();
  ASSERT_TRUE(other);
  EXPECT_NE(other->case_id, crashed->case_id);
  EXPECT_FALSE(queue_.claim());
  clock_.advance(JobQueue::kBackOff);
  EXPECT_EQ(queue_.claim()->case_id, crashed->case_id);
}

TEST_F(JobQueueTest, BackOffEndsThoughTheClockWasSetBack) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
  queue_.end(*queue_.claim(), RunEnding::crashed, "killed by signal 9");
  EXPECT_FALSE(queue_.claim());
  clock_.jump(-24h);
  EXPECT_TRUE(queue_.claim());
}

TEST_F(JobQueueTest, RunThatCouldNotBeStartedIsNoAttemptAndWaits) {
  queue_.submit(sample_study("one", {{"Ca", {0.25}}}));
  const auto claim = queue_.claim();
  EXPECT_TRUE(queue_.put_back(*claim, "no memory"));
  EXPECT_FALSE(queue_.put_back(*claim, "no memory"));
  EXPECT_EQ(count("attempts"), 0);
  EXPECT_FALSE(queue_.claim());
  clock_.advance(JobQueue::kBackOff);
  EXPECT_EQ(queue_.claim()->attempt, 1);
}

TEST_F(JobQueueTest, KnownStudyKeepsItsCasesThoughThisProgramWouldNameThemOtherwise) {
  const std::string id = queue_.submit(two_cases_).study_id;
  Study other = two_cases_;
  for (Case& c : other.cases) c.V = 7;  // as if the canonical form had changed since
  EXPECT_EQ(queue_.submit(other).study_id, id);
  EXPECT_EQ(count("cases"), 2);
}

TEST_F(JobQueueTest, StudiesOfOnePriorityTakeTurns) {
  queue_.submit(sample_study("first", {{"Ca", {0.1, 0.2, 0.3}}}));
  queue_.submit(sample_study("second", {{"Ca", {0.4, 0.5}}}));
  std::vector<double> order;
  while (const auto claim = queue_.claim()) order.push_back(nlohmann::json::parse(claim->document)["Ca"]);
  EXPECT_THAT(order, testing::ElementsAre(0.1, 0.4, 0.2, 0.5, 0.3));
}

TEST_F(JobQueueTest, HigherPriorityGoesFirst) {
  queue_.submit(sample_study("first", {{"Ca", {0.1}}}));
  EXPECT_TRUE(queue_.set_priority(queue_.submit(sample_study("urgent", {{"Ca", {0.4}}})).study_id, 1));
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.4);
  EXPECT_FALSE(queue_.set_priority("nobody-0000", 1));
}

TEST_F(JobQueueTest, PausedStudyStartsNothingUnlessAnotherWantsIt) {
  const std::string id = queue_.submit(two_cases_).study_id;
  EXPECT_TRUE(queue_.pause(id, true));
  EXPECT_FALSE(queue_.claim());
  queue_.submit(sample_study("other", {{"Ca", {0.75}}}));
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.75);
  EXPECT_FALSE(queue_.claim());
  queue_.pause(id, false);
  EXPECT_EQ(nlohmann::json::parse(queue_.claim()->document)["Ca"], 0.25);
}

TEST_F(JobQueueTest, PausedStudyThatIsSubmittedAgainIsResumed) {
  const std::string id = queue_.submit(two_cases_).study_id;
  queue_.pause(id, true);
  EXPECT_TRUE(queue_.submit(two_cases_).is_resumed);
  EXPECT_TRUE(queue_.claim());
  EXPECT_FALSE(queue_.submit(two_cases_).is_resumed);
}

/// The client has not seen the answer and asks again: that is no second wish.
TEST_F(JobQueueTest, RequestThatIsRepeatedUnderItsKeyResumesNothing) {
  const std::string id = queue_.submit(two_cases_, "key").study_id;
  queue_.pause(id, true);
  EXPECT_FALSE(queue_.submit(two_cases_, "key").is_resumed);
  EXPECT_FALSE(queue_.claim());
}

TEST_F(JobQueueTest, RetryQueuesTheFailedCasesAlone) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const auto failed = queue_.claim();
  queue_.end(*failed, RunEnding::failed, "no memory");
  queue_.end(*queue_.claim(), RunEnding::diverged, "it tore");
  EXPECT_TRUE(queue_.retry(id));
  EXPECT_EQ(queue_.claim()->case_id, failed->case_id);
  EXPECT_FALSE(queue_.claim());
  EXPECT_FALSE(queue_.retry("nobody-0000"));
}

TEST_F(JobQueueTest, RetryOfACancelledStudyQueuesNothing) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const auto failed = queue_.claim();
  queue_.end(*failed, RunEnding::failed, "no memory");
  queue_.cancel(id);
  EXPECT_TRUE(queue_.retry(id));
  EXPECT_EQ(state_of(failed->case_id), "failed");
  EXPECT_TRUE(replace_failed(database_, id, "fine").empty());
  EXPECT_EQ(count("cases"), 2);
}

TEST_F(JobQueueTest, KeyStandsForOneStudy) {
  const std::string id = queue_.submit(two_cases_, "key").study_id;
  EXPECT_EQ(queue_.submit(two_cases_, "key").study_id, id);
  EXPECT_THROW(queue_.submit(sample_study("other", {{"Ca", {1}}}), "key"), KeyReused);
  EXPECT_EQ(count("studies"), 1);
}

/// Any history of commands leaves the sums as a new count would make them.
TEST_F(JobQueueTest, KeptSumsAreThoseOfACountAfterAnyHistory) {
  const auto sums = [&] {
    std::string all;
    for (const char* sql :
         {"SELECT group_concat(study_id || ' ' || queued || ' ' || running || ' ' || done || ' ' || failed "
          "|| ' ' ||"
          " diverged || ' ' || cancelled || ' ' || tumbling || ' ' || undecided, ', ') FROM schedule",
          "SELECT group_concat(study_number || ' ' || position || ' ' || case_id || ' ' || not_before, ', ')"
          " FROM waiting"}) {
      Statement row = database_.query(sql);
      row.step();
      all += row.text(0) + "; ";
    }
    return all;
  };
  std::mt19937 random(1);
  std::vector<Claim> running;
  std::vector<Study> studies;
  for (double first : {0.1, 0.2, 0.3})
    studies.push_back(sample_study("s", {{"Ca", {first, first + 0.1, first + 0.2}}}));
  for (int step = 0; step < 400; ++step) {
    const Study& study = studies[random() % studies.size()];
    const auto choice = random() % 9;
    if (choice == 0) queue_.submit(study);
    if (choice == 1) queue_.cancel(queue_.submit(study).study_id);
    if (choice == 2) queue_.retry(queue_.submit(study).study_id);
    if (choice == 3 || choice == 4)
      if (const auto claim = queue_.claim()) running.push_back(*claim);
    if (choice == 8)
      replace_failed(database_, queue_.submit(study).study_id, {{"kdt", 0.001 + 0.0001 * step}});
    if (choice > 4 && choice < 8 && !running.empty()) {
      const Claim claim = running.back();
      running.pop_back();
      if (choice == 5) queue_.end(claim, random() % 2 ? RunEnding::failed : RunEnding::done, "");
      if (choice == 6) queue_.end(claim, RunEnding::crashed, "it died");
      if (choice == 7) queue_.end(claim, RunEnding::interrupted, "power cut");
      if (choice == 5)
        store_result(database_, claim.case_id, {{"motion", random() % 2 ? "tumbling" : "undecided"}});
    }
    clock_.advance(1s);
    const std::string kept = sums();
    database_.execute_script(kRecount);
    ASSERT_EQ(kept, sums()) << "after step " << step;
  }
}

/// Six points, two cases: Re has no effect on boundary integrals.
Study merged_study() {
  return parse_study(nlohmann::json::parse(R"({"name": "merged", "base": {"fluid": "stokes"},
    "axes": {"Ca": [0.1, 0.2], "Re": [0, 0.05, 0.1]}})"))
      .value.value();
}

TEST_F(JobQueueTest, PointsOfOneCaseAreAllKeptAndTheCaseCountsOnce) {
  const std::string id = queue_.submit(merged_study()).study_id;
  EXPECT_EQ(count("study_cases"), 6);
  EXPECT_EQ(count("cases"), 2);
  EXPECT_EQ(text("SELECT asked FROM study_cases WHERE study_id = ? AND position = 4", id),
            R"({"Ca":0.2,"Re":0.05,"fluid":"stokes"})");
  const auto counts = [&] {
    return text(
        "SELECT points || ' ' || queued || ' ' || running || ' ' || done || ' ' || tumbling FROM schedule"
        " WHERE study_id = ?",
        id);
  };
  EXPECT_EQ(counts(), "6 2 0 0 0");
  const auto claim = queue_.claim();
  EXPECT_EQ(counts(), "6 1 1 0 0");
  queue_.end(*claim, RunEnding::done, "");
  store_result(database_, claim->case_id, {{"motion", "tumbling"}});
  EXPECT_EQ(counts(), "6 1 0 1 3");
  database_.execute_script(kRecount);
  EXPECT_EQ(counts(), "6 1 0 1 3");
  queue_.cancel(id);
  EXPECT_EQ(counts(), "6 0 0 1 3");
}

/// As an earlier program stored them: each case once, and not what was asked for.
TEST_F(JobQueueTest, PointsOfAnOldStudyAreDerivedFromItsDocument) {
  const std::string id = queue_.submit(merged_study()).study_id;
  database_.execute("DELETE FROM study_cases WHERE position IN (1, 2, 4, 5)");
  database_.execute("UPDATE study_cases SET asked = NULL, position = position / 3");
  database_.execute("UPDATE study_cases SET replaces = 'before' WHERE position = 1");
  database_.execute_script(kRecount);
  derive_old_points(database_);
  EXPECT_EQ(count("study_cases"), 6);
  EXPECT_EQ(text("SELECT asked FROM study_cases WHERE study_id = ? AND position = 4", id),
            R"({"Ca":0.2,"Re":0.05,"fluid":"stokes"})");
  EXPECT_EQ(text("SELECT count(*) FROM study_cases WHERE study_id = ? AND replaces = 'before'", id), "3");
  EXPECT_EQ(text("SELECT points || ' ' || queued FROM schedule WHERE study_id = ?", id), "6 2");
}

TEST_F(JobQueueTest, PointsOfAnOldStudyThatIsReadOtherwiseTodayAreThoseOfItsCases) {
  const std::string id = queue_.submit(two_cases_).study_id;
  database_.execute("UPDATE study_cases SET asked = NULL");
  database_.execute("UPDATE studies SET document = json_set(document, '$.base.colour', 'red')");
  derive_old_points(database_);
  EXPECT_EQ(
      text("SELECT json_extract(asked, '$.Ca') FROM study_cases WHERE study_id = ? AND position = 1", id),
      "0.75");
}

TEST_F(JobQueueTest, DeletedStudyIsGoneWithTheCasesThatNoOtherWants) {
  const std::string id = queue_.submit(two_cases_).study_id;
  const std::string other = queue_.submit(sample_study("other", {{"Ca", {0.75, 1}}})).study_id;
  const auto deletion = queue_.remove(id);
  ASSERT_TRUE(deletion);
  EXPECT_EQ(deletion->deleted, 1);
  EXPECT_EQ(deletion->kept, 1);
  EXPECT_EQ(count("studies"), 1);
  EXPECT_EQ(queue_.delete_unwanted(10), std::vector<std::string>{case_id(two_cases_.cases[0])});
  EXPECT_EQ(count("cases"), 2);
  EXPECT_EQ(count("waiting"), 2);
  EXPECT_EQ(state_of(case_id(two_cases_.cases[1])), "queued");
  EXPECT_FALSE(queue_.remove(id));
  EXPECT_TRUE(queue_.remove(other));
  queue_.delete_unwanted(10);
  for (const char* table : {"studies", "study_cases", "schedule", "waiting", "cases", "attempts", "results"})
    EXPECT_EQ(count(table), 0) << table;
}

TEST_F(JobQueueTest, RunningCaseOfADeletedStudyEndsBeforeItGoes) {
  const std::string id = queue_.submit(sample_study("one", {{"Ca", {0.25}}})).study_id;
  const Claim claim = queue_.claim().value();
  queue_.remove(id);
  EXPECT_TRUE(queue_.is_to_be_cancelled(claim));
  EXPECT_TRUE(queue_.delete_unwanted(10).empty());
  EXPECT_TRUE(queue_.end(claim, RunEnding::interrupted, "stopped"));
  EXPECT_EQ(queue_.delete_unwanted(10).size(), 1u);
  EXPECT_EQ(count("cases"), 0);
}

TEST_F(JobQueueTest, CaseThatIsSubmittedAgainBeforeItIsDeletedStays) {
  queue_.remove(queue_.submit(two_cases_).study_id);
  queue_.submit(two_cases_);
  EXPECT_TRUE(queue_.delete_unwanted(10).empty());
  EXPECT_EQ(count("unwanted_cases"), 0);
  EXPECT_EQ(state_of(case_id(two_cases_.cases[0])), "queued");
}

TEST_F(JobQueueTest, DeletedCaseIsRememberedUntilItsDirectoryIsGone) {
  queue_.remove(queue_.submit(two_cases_).study_id);
  const std::vector<std::string> ids = queue_.delete_unwanted(10);
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(queue_.delete_unwanted(10), ids) << "a daemon was killed in between";
  queue_.forget(ids);
  EXPECT_TRUE(queue_.delete_unwanted(10).empty());
}

TEST_F(JobQueueTest, CaseThatAnotherOneReplacesIsKeptWithIt) {
  const std::string id = queue_.submit(sample_study("one", {{"Ca", {0.25}}})).study_id;
  const Claim claim = queue_.claim().value();
  queue_.end(claim, RunEnding::failed, "no answer");
  ASSERT_TRUE(replace_failed(database_, id, "fine").empty());
  queue_.remove(queue_.submit(sample_study("again", {{"Ca", {0.25}}})).study_id);
  EXPECT_TRUE(queue_.delete_unwanted(10).empty());
  EXPECT_EQ(state_of(claim.case_id), "failed");
  EXPECT_EQ(queue_.remove(id)->deleted, 2);
}

TEST_F(JobQueueTest, TotalsFollowTheCasesAndNeverLoseAnAttempt) {
  const auto total = [&](const char* what, const char* name) {
    Statement row = database_.query("SELECT count FROM totals WHERE what = ? AND name = ?", what, name);
    return row.step() ? row.integer(0) : 0;
  };
  const std::string id = queue_.submit(two_cases_).study_id;
  EXPECT_EQ(total("cases", "queued"), 2);
  queue_.end(queue_.claim().value(), RunEnding::done, "");
  EXPECT_EQ(total("cases", "queued"), 1);
  EXPECT_EQ(total("cases", "done"), 1);
  queue_.remove(id);
  queue_.delete_unwanted(10);
  EXPECT_EQ(total("cases", "done"), 0);
  EXPECT_EQ(total("attempts", "done"), 1);
}

}  // namespace
}  // namespace capstan
