// Studies that seek a boundary: the points that follow from recorded results.
#include "runner/daemon/extend_search.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "runner/queries/boundary.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Runs whose score falls from tumbling to tank-treading and is 0 at Ca = 0.1 V.
class ExtendSearchTest : public ServiceFixture {
 protected:
  static Study sought(const std::string& name = "sought") {
    return parse_study(
               {{"name", name},
                {"base",
                 {{"shape", "biconcave"}, {"law", "skalak"}, {"C", 5}, {"E_b", 0.015}, {"fidelity", "fast"}}},
                {"boundary", {{"along", "Ca"}, {"between", {0.05, 1}}, {"for", {{"V", {2, 4}}}}}}})
        .value.value();
  }

  void complete_case(const RunHandle& run) {
    const json document = json::parse(std::ifstream(directory_of(run).case_file()));
    const double score = 0.3 * std::log(0.1 * document["V"].get<double>() / document["Ca"].get<double>());
    const char* motion = score >= 0.06 ? "tumbling" : score <= -0.06 ? "tank_treading" : "transition";
    std::ofstream(directory_of(run).result_file())
        << json{{"stop", "reached_end"},
                {"motion", motion},
                {"evidence", {{"turns", 2}, {"r", score > 0 ? 1 : 0}, {"D_min", std::abs(score)}}},
                {"error", {{"Q", 0.01}}},
                {"confirmed", std::abs(std::abs(score) - 0.06) > 0.01}};
    executor_.exit(run, 0);
  }

  /// Completes the running cases in random order, one a tick, until nothing runs.
  void work(unsigned seed, int restart_every = 0) {
    std::mt19937 random(seed);
    service_->tick();
    for (int ended = 1; !executor_.running.empty(); ++ended) {
      complete_case(executor_.running[random() % executor_.running.size()]);
      service_->tick();
      if (restart_every > 0 && ended % restart_every == 0) kill_and_restart();
    }
  }

  /// The cases of a study that was completed without a kill, and removed.
  std::vector<std::string> cases_of_removed_study() {
    const std::string study = service_->submit(sought("one")).study_id;
    work(1);
    const std::vector<std::string> cases = ids_of_cases(study);
    service_->remove(study);
    for (int i = 0; i < 5; ++i) service_->tick();
    return cases;
  }

  /// The runs end with the daemon.
  void kill_and_restart() {
    restart();
    executor_.running.clear();
    service_->tick();
  }

  std::vector<std::string> ids_of_cases(const std::string& id) {
    std::vector<std::string> ids;
    for (const ordered_json& item : all_cases(id)) ids.push_back(item["id"]);
    std::ranges::sort(ids);
    return ids;
  }
  ordered_json all_cases(const std::string& id) { return cases(id); }
  ordered_json boundary(const std::string& id) {
    const Readers::Reader reader = service_->reader();
    return find_boundary(*reader, id).value();
  }
};

TEST_F(ExtendSearchTest, StudyIsDoneWhenTheBoundaryIsLocatedInEveryRow) {
  const std::string id = service_->submit(sought()).study_id;
  work(1);
  EXPECT_EQ(study(id)["state"], "done");
  EXPECT_EQ(study(id)["expected_points"], 0);
  const ordered_json found = boundary(id);
  EXPECT_EQ(found["searching"], false);
  ASSERT_EQ(found["rows"].size(), 2u);
  for (const ordered_json& row : found["rows"]) {
    ASSERT_EQ(row["crossings"].size(), 1u);
    const ordered_json& crossing = row["crossings"][0];
    const double exact = 0.1 * row["at"]["V"].get<double>();
    EXPECT_EQ(crossing["found"], true);
    EXPECT_NEAR(crossing["value"], exact, 0.01 * exact);
    EXPECT_LT(crossing["low"], exact);
    EXPECT_GT(crossing["high"], exact);
    EXPECT_EQ(crossing["from"], "tumbling");
    EXPECT_EQ(crossing["to"], "tank_treading");
  }
  ASSERT_EQ(found["curves"].size(), 1u);
  EXPECT_EQ(found["curves"][0]["points"].size(), 2u);
}

TEST_F(ExtendSearchTest, CrossingsAreJoinedAlongTheLastParameterThatVaries) {
  const auto joined_over = [&](const char* name, const json& rows) {
    json document = {{"name", name}, {"base", {{"shape", "biconcave"}, {"fidelity", "fast"}}}};
    document["boundary"] = {{"along", "Ca"}, {"between", {0.05, 1}}, {"for", rows}};
    const std::string id = service_->submit(parse_study(document).value.value()).study_id;
    work(1);
    return boundary(id)["curves"][0]["over"];
  };
  EXPECT_EQ(joined_over("a", {{"V", {2, 4}}, {"E_b", {0.015}}}), "V");
  EXPECT_EQ(joined_over("b", {{"V", {2}}}), "V") << "a single row";
  EXPECT_TRUE(joined_over("c", json::object()).is_null()) << "a single row without a parameter";
}

TEST_F(ExtendSearchTest, SameCasesFollowWhateverTheOrderInWhichTheyEnd) {
  const std::vector<std::string> cases_of_first = cases_of_removed_study();
  const std::string second = service_->submit(sought("two")).study_id;
  work(2);
  EXPECT_EQ(ids_of_cases(second), cases_of_first);
}

TEST_F(ExtendSearchTest, SameCasesFollowIfTheDaemonIsKilledAgainAndAgain) {
  const std::vector<std::string> cases_of_first = cases_of_removed_study();
  const std::string second = service_->submit(sought("two")).study_id;
  work(3, 4);
  EXPECT_EQ(ids_of_cases(second), cases_of_first);
}

TEST_F(ExtendSearchTest, CasesThatAnotherStudyHasComputedNeedNoFurtherRun) {
  const std::string first = service_->submit(sought("one")).study_id;
  work(1);
  const std::string second = service_->submit(sought("two")).study_id;
  EXPECT_EQ(study(second)["state"], "done");
  EXPECT_EQ(ids_of_cases(second), ids_of_cases(first));
}

TEST_F(ExtendSearchTest, CancelledStudyAsksForNothingUntilItIsSubmittedAgain) {
  const std::string id = service_->submit(sought()).study_id;
  service_->tick();
  service_->cancel(id);
  for (const RunHandle& run : std::vector(executor_.running)) complete_case(run);
  service_->tick();
  EXPECT_EQ(study(id)["points"], 2 * StudyBoundary::kExplored);
  service_->submit(sought());
  work(1);
  EXPECT_EQ(study(id)["state"], "done");
  EXPECT_GT(study(id)["points"], 2 * StudyBoundary::kExplored);
}

TEST_F(ExtendSearchTest, AxesListTheValuesOfAllPoints) {
  const std::string id = service_->submit(sought()).study_id;
  work(1);
  std::set<double> values;
  for (const ordered_json& item : all_cases(id)) values.insert(item["asked"]["Ca"].get<double>());
  EXPECT_EQ(study(id)["axes"][0]["values"], ordered_json(values));
}

TEST_F(ExtendSearchTest, GridIsRefinedWhereTheMotionChanges) {
  const Study study_of_grid = parse_study({{"name", "grid"},
                                           {"base", {{"shape", "biconcave"}, {"fidelity", "fast"}}},
                                           {"axes", {{"Ca", {0.1, 0.5, 0.9}}, {"V", {2, 4}}}},
                                           {"refine", {{"Ca", 0.1}, {"V", 1}}}})
                                  .value.value();
  const std::string id = service_->submit(study_of_grid).study_id;
  work(1);
  std::set<double> at_three;
  for (const ordered_json& item : all_cases(id))
    if (item["asked"]["V"] == 3) at_three.insert(item["asked"]["Ca"].get<double>());
  EXPECT_THAT(at_three, ::testing::IsSupersetOf({0.2, 0.3}));  // around the boundary at 0.3
  EXPECT_EQ(study(id)["state"], "done");
  EXPECT_EQ(study(id)["boundary"], nullptr);
}

}  // namespace
}  // namespace capstan
