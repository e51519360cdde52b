#include "runner/daemon/submit_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/queue_fixture.hpp"

namespace capstan {
namespace {

using ::testing::MatchesRegex;

class SubmitStudyTest : public QueueFixture {};

TEST_F(SubmitStudyTest, StudyIdIsItsNameInSmallLettersAndFourDigits) {
  EXPECT_THAT(submit(sample_study("Fig16a", {{"Ca", {0.1}}})).study_id, MatchesRegex("fig16a-[0-9a-f]{4}"));
}

TEST_F(SubmitStudyTest, EqualStudyIsTheSameStudyAndAddsNoCases) {
  const Submission first = submit(two_cases_);
  const Submission second = submit(two_cases_);
  EXPECT_TRUE(first.is_new);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(first.study_id, second.study_id);
  EXPECT_EQ(count("cases"), 2);
}

TEST_F(SubmitStudyTest, CaseOfTwoStudiesIsComputedOnce) {
  submit(two_cases_);
  submit(sample_study("other", {{"Ca", {0.75, 1.0}}}));
  EXPECT_EQ(count("cases"), 3);
  EXPECT_EQ(count("study_cases"), 4);
}

TEST_F(SubmitStudyTest, StudiesOfOneNameHaveDifferentIds) {
  const std::string first = submit(two_cases_).study_id;
  EXPECT_NE(submit(sample_study("two", {{"Ca", {0.25}}})).study_id, first);
}

TEST_F(SubmitStudyTest, CancelledStudyThatIsSubmittedAgainIsQueuedAgain) {
  const std::string id = submit(two_cases_).study_id;
  const auto running = queue_.claim();
  queue_.cancel(id);
  submit(two_cases_);
  EXPECT_FALSE(queue_.to_be_cancelled().contains(running->token));
  EXPECT_TRUE(queue_.claim());
}

TEST_F(SubmitStudyTest, KnownStudyKeepsItsCasesEvenIfTheirIdsWouldDifferToday) {
  const std::string id = submit(two_cases_).study_id;
  Study other = two_cases_;
  for (Case& c : other.cases) c.V = 7;  // as if the canonical form had changed since
  EXPECT_EQ(submit(other).study_id, id);
  EXPECT_EQ(count("cases"), 2);
}

TEST_F(SubmitStudyTest, PausedStudyThatIsSubmittedAgainIsResumed) {
  const std::string id = submit(two_cases_).study_id;
  queue_.pause(id, true);
  EXPECT_TRUE(submit(two_cases_).is_resumed);
  EXPECT_TRUE(queue_.claim());
  EXPECT_FALSE(submit(two_cases_).is_resumed);
}

/// A client that missed the answer repeats its request; it does not ask for the study to be resumed.
TEST_F(SubmitStudyTest, RequestThatIsRepeatedUnderItsKeyResumesNothing) {
  const std::string id = submit(two_cases_, "key").study_id;
  queue_.pause(id, true);
  EXPECT_FALSE(submit(two_cases_, "key").is_resumed);
  EXPECT_FALSE(queue_.claim());
}

TEST_F(SubmitStudyTest, KeyStandsForOneStudy) {
  const std::string id = submit(two_cases_, "key").study_id;
  EXPECT_EQ(submit(two_cases_, "key").study_id, id);
  EXPECT_THROW(submit(sample_study("other", {{"Ca", {1}}}), "key"), KeyReused);
  EXPECT_EQ(count("studies"), 1);
}

}  // namespace
}  // namespace capstan
