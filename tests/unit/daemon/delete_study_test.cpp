#include "runner/daemon/delete_study.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runner/daemon/replacement.hpp"
#include "runner/recording/result.hpp"
#include "solver/case/content_id.hpp"
#include "tests/support/queue_fixture.hpp"

namespace capstan {
namespace {

class DeleteStudyTest : public QueueFixture {};

TEST_F(DeleteStudyTest, DeletedStudyIsGoneWithTheCasesThatNoOtherWants) {
  const std::string id = submit(two_cases_).study_id;
  const std::string other = submit(sample_study("other", {{"Ca", {0.75, 1}}})).study_id;
  const auto deletion = remove(id);
  ASSERT_TRUE(deletion);
  EXPECT_EQ(deletion->deleted, 1);
  EXPECT_EQ(deletion->kept, 1);
  EXPECT_EQ(count("studies"), 1);
  EXPECT_EQ(delete_unwanted(), std::vector<std::string>{case_id(two_cases_.cases[0])});
  EXPECT_EQ(count("cases"), 2);
  EXPECT_EQ(count("waiting"), 2);
  EXPECT_EQ(state_of(case_id(two_cases_.cases[1])), "queued");
  EXPECT_FALSE(remove(id));
  EXPECT_TRUE(remove(other));
  delete_unwanted();
  for (const char* table :
       {"studies", "study_cases", "schedule", "tallies", "waiting", "cases", "attempts", "results"})
    EXPECT_EQ(count(table), 0) << table;
}

TEST_F(DeleteStudyTest, RunningCaseOfADeletedStudyEndsBeforeItGoes) {
  const std::string id = submit(sample_study("one", {{"Ca", {0.25}}})).study_id;
  const Claim claim = queue_.claim().value();
  remove(id);
  EXPECT_TRUE(queue_.to_be_cancelled().contains(claim.token));
  EXPECT_TRUE(delete_unwanted().empty());
  EXPECT_TRUE(queue_.end(claim, RunEnding::interrupted, "stopped"));
  EXPECT_EQ(delete_unwanted().size(), 1u);
  EXPECT_EQ(count("cases"), 0);
}

TEST_F(DeleteStudyTest, CaseThatIsSubmittedAgainBeforeItIsDeletedStays) {
  remove(submit(two_cases_).study_id);
  submit(two_cases_);
  EXPECT_TRUE(delete_unwanted().empty());
  EXPECT_EQ(count("unwanted_cases"), 0);
  EXPECT_EQ(state_of(case_id(two_cases_.cases[0])), "queued");
}

TEST_F(DeleteStudyTest, DeletedCaseIsRememberedUntilItsDirectoryIsGone) {
  remove(submit(two_cases_).study_id);
  const std::vector<std::string> ids = delete_unwanted();
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(delete_unwanted(), ids) << "a daemon was killed in between";
  forget_deleted(database_, ids);
  EXPECT_TRUE(delete_unwanted().empty());
}

TEST_F(DeleteStudyTest, CaseThatAnotherOneReplacesIsKeptWithIt) {
  const std::string id = submit(sample_study("one", {{"Ca", {0.25}}})).study_id;
  const Claim claim = queue_.claim().value();
  queue_.end(claim, RunEnding::failed, "no answer");
  ASSERT_TRUE(replace_failed(database_, id, "fine").empty());
  remove(submit(sample_study("again", {{"Ca", {0.25}}})).study_id);
  EXPECT_TRUE(delete_unwanted().empty());
  EXPECT_EQ(state_of(claim.case_id), "failed");
  EXPECT_EQ(remove(id)->deleted, 2);
}

}  // namespace
}  // namespace capstan
