#include "runner/daemon/scheduler.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/file_bytes.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST_F(ServiceTest, StartsAsManyRunsAsThereAreCores) {
  submit({{"Ca", {0.25, 0.5, 0.75}}});
  EXPECT_THAT(executor_.running, SizeIs(2));
  complete("run 1", "tumbling");
  service_->tick();
  EXPECT_THAT(executor_.running, ElementsAre("run 2", "run 3"));
}

TEST_F(ServiceTest, RunDirectoryHoldsTheCanonicalCase) {
  submit({{"Ca", {0.25}}});
  const auto written = nlohmann::ordered_json::parse(std::ifstream(directory_of("run 1").case_file()));
  const ParsedCase parsed = parse_case(written);
  ASSERT_TRUE(parsed.value);
  EXPECT_EQ(parsed.value->Ca, 0.25);
  EXPECT_EQ(to_json(*parsed.value), written);
}

/// The study ends at kt = 30; the same cases with another end.
Study until(const nlohmann::json& end) {
  nlohmann::json document = study_document("prolonged", {{"Ca", {0.25}}});
  document["base"]["until"] = end;
  return parse_study(document).value.value();
}

TEST_F(ServiceTest, CaseGoesOnFromTheEndOfADoneOneWithEqualSteps) {
  submit({{"Ca", {0.25}}});
  overwrite(directory_of("run 1").checkpoint_paths()[1], "the state at kt = 30");
  std::filesystem::create_directories(directory_of("run 1").shapes_directory());
  overwrite(directory_of("run 1").frame_file(0), "a shape");
  std::filesystem::create_directories(directory_of("run 1").rung(42).path());
  overwrite(directory_of("run 1").rung(42).checkpoint_paths()[1], "that of the companion");
  write_history("run 1", "{\"kt\":30}\n");
  complete("run 1", "undecided");
  service_->tick();
  service_->submit(until({{"kt", 60}}));
  service_->tick();
  EXPECT_EQ(file_bytes(directory_of("run 2").checkpoint_paths()[1]), "the state at kt = 30");
  EXPECT_EQ(file_bytes(directory_of("run 2").frame_file(0)), "a shape");
  EXPECT_EQ(file_bytes(directory_of("run 2").rung(42).checkpoint_paths()[1]), "that of the companion");
}

TEST_F(ServiceTest, CaseThatMightHaveEndedBeforeADoneOneStartsAnew) {
  submit({{"Ca", {0.25}}});
  overwrite(directory_of("run 1").checkpoint_paths()[1], "the state at kt = 30");
  write_history("run 1", "{\"kt\":30}\n");
  complete("run 1", "undecided");
  service_->tick();
  service_->submit(until({{"kt", 20}}));
  service_->submit(until({{"kt", 40}, {"classified", true}}));
  service_->tick();
  for (const char* run : {"run 2", "run 3"})
    EXPECT_FALSE(std::filesystem::exists(directory_of(run).checkpoint_paths()[1])) << run;
}

TEST_F(ServiceTest, FailedCaseDoesNotStopTheOthersAndSaysWhy) {
  const std::string id = submit({{"Ca", {0.25, 0.5, 0.75}}});
  executor_.exit("run 1", 2);
  complete("run 2", "tumbling");
  service_->tick();
  complete("run 3", "tumbling");
  service_->tick();
  EXPECT_EQ(study(id)["cases"]["done"], 2);
  EXPECT_EQ(cases(id)[0]["state"], "failed");
  EXPECT_EQ(cases(id)[0]["message"], "the solver refused the case");
}

TEST_F(ServiceTest, SameStudyAgainStartsNothing) {
  submit({{"Ca", {0.25}}});
  complete("run 1", "tumbling");
  service_->tick();
  submit({{"Ca", {0.25}}});
  EXPECT_THAT(executor_.running, IsEmpty());
}

TEST_F(ServiceTest, CrashIsTriedOnceMore) {
  const std::string id = submit({{"Ca", {0.25}}});
  executor_.end("run 1", {ProcessEnd::How::signalled, 11});
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  clock_.advance(JobQueue::kBackOff);
  service_->tick();
  EXPECT_THAT(executor_.running, ElementsAre("run 2"));
  executor_.end("run 2", {ProcessEnd::How::signalled, 11});
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  EXPECT_EQ(cases(id)[0]["state"], "failed");
}

TEST_F(ServiceTest, DrainingStartsNothingAndGivesRunsBackToTheQueue) {
  const std::string id = submit({{"Ca", {0.25, 0.5, 0.75}}});
  service_->drain();
  service_->tick();
  EXPECT_THAT(executor_.asked_to_stop, SizeIs(2));
  executor_.exit("run 1", 75);
  executor_.exit("run 2", 75);
  service_->tick();
  EXPECT_TRUE(service_->is_idle());
  EXPECT_EQ(study(id)["cases"]["queued"], 3);
}

TEST_F(ServiceTest, CaseThatCannotBeStartedStaysInTheQueue) {
  executor_.is_broken = true;
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  EXPECT_THROW(service_->tick(), std::runtime_error);
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["message"], "could not be started: cannot start a process");
  EXPECT_EQ(cases(id)[0]["attempt"], 0);
  executor_.is_broken = false;
  clock_.advance(JobQueue::kBackOff);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
}

TEST_F(ServiceTest, CaseThatCannotBeStartedHoldsNobodyUp) {
  executor_.is_broken = true;
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25, 0.5}}})).study_id;
  EXPECT_THROW(service_->tick(), std::runtime_error);
  executor_.is_broken = false;
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[1]["state"], "running");
}

TEST_F(ServiceTest, CompleteDirectoryOfAQueuedCaseIsRecordedNotComputedAgain) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  const RunDirectory directory = data_.run(cases(id)[0]["id"]);
  directory.prepare("{}");
  std::ofstream(directory.result_file()) << R"({"stop": "reached_end", "motion": "tumbling"})";
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  EXPECT_EQ(cases(id)[0]["state"], "done");
  EXPECT_EQ(cases(id)[0]["motion"], "tumbling");
}

TEST_F(ServiceTest, DamagedCaseFileIsWrittenAgain) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  const RunDirectory directory = data_.run(cases(id)[0]["id"]);
  directory.prepare("half of");
  service_->tick();
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(directory.case_file())),
            nlohmann::json(cases(id)[0]["parameters"]));
}

TEST_F(ServiceTest, NothingIsStartedOnAFullDiskAndWhySaysSo) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  service_->keep_free(std::filesystem::space(data_.runs()).capacity);
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  EXPECT_THAT(service_->why_nothing_starts(), ::testing::HasSubstr("are free in"));
  service_->keep_free(0);
  service_->tick();
  EXPECT_THAT(executor_.running, SizeIs(1));
  EXPECT_EQ(service_->why_nothing_starts(), "");
}

TEST_F(ServiceTest, DeletedStudyLeavesNeitherRowsNorRunDirectories) {
  const std::string id = service_->submit(sample_study("gone", {{"Ca", {0.25, 0.75}}})).study_id;
  service_->tick();
  complete("run 1", "tumbling");
  service_->tick();
  const std::filesystem::path first = directory_of("run 1").path(), second = directory_of("run 2").path();
  EXPECT_TRUE(service_->remove(id));
  service_->tick();
  EXPECT_FALSE(std::filesystem::exists(first));
  EXPECT_EQ(executor_.asked_to_stop, std::vector<RunHandle>{"run 2"});
  EXPECT_TRUE(std::filesystem::exists(second)) << "its run has not ended";
  executor_.exit("run 2", 75);
  service_->tick();
  EXPECT_FALSE(std::filesystem::exists(second));
}

}  // namespace
}  // namespace capstan
