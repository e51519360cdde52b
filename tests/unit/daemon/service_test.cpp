#include "runner/daemon/service.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "runner/queries/why.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

TEST_F(ServiceTest, WordStandsForTheIdsThatItNamesOrBegins) {
  const auto add = [&](const char* name, double Ca) {
    return service_->submit(sample_study(name, {{"Ca", {Ca}}})).study_id;
  };
  const std::string fig1 = add("Fig1", 0.1), fig16 = add("fig16", 0.2), again = add("fig16", 0.3);
  const auto studies = [&](const std::string& word) {
    return find_ids(*service_->reader(), word)["studies"].get<std::vector<std::string>>();
  };
  EXPECT_THAT(studies("Fig1"), ElementsAre(fig1));
  EXPECT_THAT(studies("fig16"), UnorderedElementsAre(fig16, again));
  EXPECT_THAT(studies("fig"), UnorderedElementsAre(fig1, fig16, again));
  EXPECT_THAT(studies(fig16), ElementsAre(fig16));
  EXPECT_THAT(studies("g16"), IsEmpty());
  const std::string id = cases(fig1)[0]["id"];
  EXPECT_EQ(find_ids(*service_->reader(), id.substr(0, 10))["cases"][0], id);
}

TEST_F(ServiceTest, StateOfAStudyIsInOneWord) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25, 0.5, 0.75}}})).study_id;
  EXPECT_EQ(study(id)["state"], "queued");
  service_->tick();
  EXPECT_EQ(study(id)["state"], "running");
  EXPECT_EQ(service_->pause(id, true), 1);
  EXPECT_EQ(study(id)["state"], "paused");
  EXPECT_EQ(service_->pause(id, false), 1);
  for (const char* run : {"run 1", "run 2", "run 3"}) {
    complete(run, "tumbling");
    service_->tick();
  }
  EXPECT_EQ(study(id)["state"], "done");
}

TEST_F(ServiceTest, CancelledStudyThatHasEndedIsNotComplete) {
  const std::string id = submit({{"Ca", {0.25}}, {"E_b", {0.01}}, {"c0", {0, 1, 2, 3}}});  // equal costs
  complete("run 1", "tumbling");
  service_->tick();
  EXPECT_EQ(service_->cancel(id), 3);
  executor_.exit("run 2", 75);
  executor_.exit("run 3", 75);
  service_->tick();
  EXPECT_EQ(study(id)["cases"]["cancelled"], 3);
  EXPECT_EQ(study(id)["state"], "cancelled");
  EXPECT_EQ(study(id)["progress"], 0.25);
  EXPECT_EQ(cases(id)[3]["progress"], 0);
}

TEST_F(ServiceTest, UndecidedCasesOfAStudySayWhatTheyLack) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.1, 0.2}}})).study_id;
  service_->tick();
  complete("run 1", "tumbling");
  std::ofstream(directory_of("run 2").result_file())
      << R"({"stop": "reached_end", "motion": "undecided", "explanation": "0.4 half-turns were seen."})";
  executor_.exit("run 2", 0);
  service_->tick();
  const auto reasons = why_study(*service_->reader(), id, service_->places()).value()["reasons"];
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0]["reason"],
            "undecided: 0.4 half-turns were seen. (case " + std::string(cases(id)[1]["id"]) + ")");
  EXPECT_EQ(reasons[1], nlohmann::ordered_json({{"cases", 1}, {"reason", "done, with an answer"}}));
}

TEST_F(ServiceTest, ReasonsOfAStudyAreCounted) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.1, 0.2, 0.3, 0.4}}})).study_id;
  service_->tick();
  executor_.exit("run 1", 2);
  executor_.exit("run 2", 2);
  service_->pause(id, true);
  service_->tick();
  const auto reasons = why_study(*service_->reader(), id, service_->places()).value()["reasons"];
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0]["cases"], 2);
  EXPECT_EQ(reasons[0]["reason"], "queued; the study is paused: capstan resume " + id);
  EXPECT_EQ(reasons[1]["cases"], 2);
  EXPECT_EQ(reasons[1]["reason"],
            "failed: the solver refused the case (case " + std::string(cases(id)[0]["id"]) + ")");
  EXPECT_FALSE(why_study(*service_->reader(), "nobody-0000", service_->places()));
}

TEST_F(ServiceTest, FailedAndDivergedCasesAreReplacedByFinerOnes) {
  const std::string id = submit({{"Ca", {0.25, 0.5, 0.75}}});
  const std::string diverged = cases(id)[0]["id"], failed = cases(id)[1]["id"];
  executor_.exit("run 1", 3);
  executor_.exit("run 2", 2);
  service_->tick();
  EXPECT_THAT(service_->retry_at(id, "fine"), IsEmpty());
  EXPECT_EQ(study(id)["cases"]["queued"], 2);
  EXPECT_EQ(study(id)["cases"]["diverged"], 0);
  EXPECT_EQ(study(id)["cases"]["failed"], 0);
  EXPECT_EQ(cases(id)[0]["replaces"], diverged);
  EXPECT_EQ(cases(id)[1]["replaces"], failed);
  EXPECT_FALSE(cases(id)[2].contains("replaces"));
  EXPECT_EQ(cases(id)[0]["parameters"]["Ca"], 0.25);
  EXPECT_NE(cases(id)[0]["parameters"]["fidelity"], cases(id)[2]["parameters"]["fidelity"]);
}

TEST_F(ServiceTest, ARunThatDivergedHasNoMotionInListsCountsAndDiagrams) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  std::ofstream(directory_of("run 1").result_file()) << R"({"stop": "diverged", "motion": "tank_treading"})";
  executor_.exit("run 1", 3);
  complete("run 2", "tumbling");
  service_->tick();
  EXPECT_TRUE(cases(id)[0]["motion"].is_null());
  EXPECT_EQ(study(id)["motions"]["tank_treading"], 0);
  EXPECT_EQ(study(id)["motions"]["tumbling"], 1);
  EXPECT_THAT(cases(id, {{"motion", "tank_treading"}}), IsEmpty());
}

TEST_F(ServiceTest, CaseThatAnotherIsReplacedByIsOneCaseAtTwoPoints) {
  nlohmann::json document = study_document("study", {{"fidelity", {"fast", "standard"}}, {"Ca", {0.25}}});
  document["base"].erase("fidelity");
  const std::string id = service_->submit(parse_study(document).value.value()).study_id;
  service_->tick();
  executor_.exit("run 1", 3);
  service_->tick();
  EXPECT_THAT(service_->retry_at(id, "standard"), IsEmpty());
  EXPECT_EQ(cases(id)[0]["id"], cases(id)[1]["id"]);
  EXPECT_EQ(cases(id)[1].value("same_as", 0), 1);
  complete("run 2", "tumbling");
  service_->tick();
  EXPECT_EQ(study(id)["points"], 2);
  EXPECT_EQ(study(id)["cases"]["total"], 1);
  EXPECT_EQ(study(id)["cases"]["done"], 1);
  EXPECT_EQ(study(id)["motions"]["tumbling"], 2);
  EXPECT_EQ(study(id)["progress"], 1);
}

TEST_F(ServiceTest, RetryAtAnInvalidFidelityChangesNothingAndReportsAllIssues) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  executor_.exit("run 1", 3);
  service_->tick();
  const Issues issues = service_->retry_at(id, {{"nodes", 7}, {"colour", "red"}});
  EXPECT_THAT(issues, SizeIs(2));
  EXPECT_EQ(cases(id)[0]["state"], "diverged");
}

TEST_F(ServiceTest, RetryAtAnInvalidFidelityIsAnIssueWhereNothingHasFailed) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  EXPECT_THAT(service_->retry_at(id, "finest"), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, nullptr), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, {{"colour", "red"}}), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, "fine"), IsEmpty());
  service_->cancel(id);
  EXPECT_THAT(service_->retry_at(id, "finest"), SizeIs(1));
}

TEST_F(ServiceTest, DamagedDatabaseTakesNoStudyAndRecordsNothing) {
  const std::string id = submit({{"Ca", {0.25}}});
  complete("run 1", "tumbling");
  service_->report_damage("page 7 is damaged");
  EXPECT_THROW(submit({{"Ca", {0.5}}}), DatabaseDamaged);
  EXPECT_THROW(service_->pause(id, true), DatabaseDamaged);
  EXPECT_THROW(service_->tick(), DatabaseDamaged);
  EXPECT_EQ(cases(id)[0]["state"], "running");
  service_->drain();
  EXPECT_THROW(service_->tick(), DatabaseDamaged);
  EXPECT_TRUE(service_->has_ended());
}

}  // namespace
}  // namespace capstan
