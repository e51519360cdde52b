// Counts that the triggers of schema/queue.sql keep.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "runner/daemon/replacement.hpp"
#include "runner/recording/result.hpp"
#include "runner/store/schema.hpp"
#include "tests/support/queue_fixture.hpp"

namespace capstan {
namespace {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

class TalliesTest : public QueueFixture {};

TEST_F(TalliesTest, EqualARecountAfterAnyHistoryOfCommands) {
  const auto sums = [&] {
    std::string all;
    for (const char* sql :
         {"SELECT group_concat(study_id || ' ' || word || ' ' || count || ' ' || round(cost, 6), ', ')"
          " FROM tallies WHERE count > 0",
          "SELECT group_concat(study_id || ' ' || waiting, ', ') FROM schedule",
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
    if (choice == 0) submit(study);
    if (choice == 1) queue_.cancel(submit(study).study_id);
    if (choice == 2) queue_.retry(submit(study).study_id);
    if (choice == 3 || choice == 4)
      if (const auto claim = queue_.claim()) running.push_back(*claim);
    if (choice == 8) replace_failed(database_, submit(study).study_id, {{"kdt", 0.001 + 0.0001 * step}});
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

TEST_F(TalliesTest, CountACaseOnceAndEachOfItsPoints) {
  const std::string id = submit(study_of_merged_points()).study_id;
  EXPECT_EQ(count("study_cases"), 6);
  EXPECT_EQ(count("cases"), 2);
  EXPECT_EQ(text("SELECT asked FROM study_cases WHERE study_id = ? AND position = 4", id),
            R"({"Ca":0.2,"Re":0.05,"fluid":"stokes"})");
  const auto counts = [&] {
    std::vector<std::int64_t> values;
    for (const char* word : {"points", "queued", "running", "done", "tumbling"})
      values.push_back(tally(id, word));
    return values;
  };
  EXPECT_THAT(counts(), ElementsAre(6, 2, 0, 0, 0));
  const auto claim = queue_.claim();
  EXPECT_THAT(counts(), ElementsAre(6, 1, 1, 0, 0));
  queue_.end(*claim, RunEnding::done, "");
  store_result(database_, claim->case_id, {{"motion", "tumbling"}});
  EXPECT_THAT(counts(), ElementsAre(6, 1, 0, 1, 3));
  database_.execute_script(kRecount);
  EXPECT_THAT(counts(), ElementsAre(6, 1, 0, 1, 3));
  queue_.cancel(id);
  EXPECT_THAT(counts(), ElementsAre(6, 0, 0, 1, 3));
}

TEST_F(TalliesTest, OverAllStudiesFollowTheCasesAndKeepEveryAttempt) {
  const auto total = [&](const char* what, const char* name) {
    Statement row = database_.query("SELECT count FROM totals WHERE what = ? AND name = ?", what, name);
    return row.step() ? row.integer(0) : 0;
  };
  const std::string id = submit(two_cases_).study_id;
  EXPECT_EQ(total("cases", "queued"), 2);
  queue_.end(queue_.claim().value(), RunEnding::done, "");
  EXPECT_EQ(total("cases", "queued"), 1);
  EXPECT_EQ(total("cases", "done"), 1);
  remove(id);
  delete_unwanted();
  EXPECT_EQ(total("cases", "done"), 0);
  EXPECT_EQ(total("attempts", "done"), 1);
}

}  // namespace
}  // namespace capstan
