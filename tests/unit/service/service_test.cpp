#include "runner/service/service.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using namespace std::chrono_literals;

class ServiceTest : public ServiceFixture {
 protected:
  std::string submit(const nlohmann::json& axes) {
    const std::string id = service_->submit(sample_study("study", axes)).study_id;
    service_->tick();
    return id;
  }
};

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

TEST_F(ServiceTest, AnswerIsRecordedWithItsEvidence) {
  const std::string id = submit({{"Ca", {0.25}}});
  write_history("run 1", "{\"kt\":30}\n");
  complete("run 1", "tumbling");
  service_->tick();
  const auto shown = cases(id)[0];
  EXPECT_EQ(shown["state"], "done");
  EXPECT_EQ(shown["motion"], "tumbling");
  EXPECT_EQ(shown["evidence"]["turns"], 2);
  EXPECT_EQ(shown["progress"], 1);
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

TEST_F(ServiceTest, ProgressFollowsTheHistory) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  write_history("run 1", "{\"kt\":15}\n");
  service_->tick();
  EXPECT_EQ(cases(id)[0]["progress"], 0.5);
  EXPECT_EQ(study(id)["progress"], 0.25);
}

TEST_F(ServiceTest, RecordedHistoryIsTheFileAsTheLastAttemptLeftIt) {
  const std::string id = submit({{"Ca", {0.25}}});
  write_history("run 1", "{\"kt\":1}\n{\"kt\":2}\n{\"kt\":3}\n");
  service_->tick();
  write_history("run 1", "{\"kt\":1}\n{\"kt\":2.5}\n");
  complete("run 1", "tumbling");
  service_->tick();
  Database reader = service_->reader();
  EXPECT_EQ(find_history(reader, cases(id)[0]["id"]).value()["kt"], nlohmann::ordered_json({1.0, 2.5}));
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
  executor_.end("run 1", {RunEnd::How::signalled, 11});
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  clock_.advance(JobQueue::kBackOff);
  service_->tick();
  EXPECT_THAT(executor_.running, ElementsAre("run 2"));
  executor_.end("run 2", {RunEnd::How::signalled, 11});
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  EXPECT_EQ(cases(id)[0]["state"], "failed");
}

TEST_F(ServiceTest, CancelledRunIsAskedToStopAndThenKilled) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->cancel(id);
  service_->tick();
  EXPECT_THAT(executor_.asked_to_stop, ElementsAre("run 1"));
  service_->tick();
  EXPECT_THAT(executor_.asked_to_stop, SizeIs(1));
  EXPECT_THAT(executor_.killed, IsEmpty());
  clock_.advance(Service::kGrace + 1ms);
  service_->tick();
  EXPECT_THAT(executor_.killed, ElementsAre("run 1"));
  EXPECT_EQ(cases(id)[0]["state"], "cancelled");
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

TEST_F(ServiceTest, RunKilledForNotStoppingIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->drain();
  service_->tick();
  clock_.advance(Service::kGrace + 1ms);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
}

TEST_F(ServiceTest, SuccessorEndsTheRunsOfADeadDaemonAndStartsThemAgain) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  restart();
  EXPECT_THAT(executor_.killed, ElementsAre("run 1", "run 2"));
  EXPECT_EQ(study(id)["cases"]["queued"], 2);
  service_->tick();
  EXPECT_THAT(executor_.running, ElementsAre("run 3", "run 4"));
}

TEST_F(ServiceTest, SuccessorRecordsARunThatCompletedMeanwhile) {
  const std::string id = submit({{"Ca", {0.25}}});
  complete("run 1", "tank_treading");
  restart();
  EXPECT_EQ(cases(id)[0]["state"], "done");
  EXPECT_EQ(cases(id)[0]["motion"], "tank_treading");
}

TEST_F(ServiceTest, SleepOfTheMachineCostsNoRun) {
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.advance(12h);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["attempt"], 1);
  EXPECT_THAT(executor_.running, ElementsAre("run 1"));
}

TEST_F(ServiceTest, RunThatStandsStillLosesItsLeaseAndIsKilled) {
  const std::string id = submit({{"Ca", {0.25}}});
  executor_.is_stopped = true;
  for (int beat = 0; beat < 6; ++beat) {
    clock_.advance(JobQueue::kHeartbeat);
    service_->tick();
  }
  EXPECT_THAT(executor_.killed, ElementsAre("run 1"));
  EXPECT_EQ(cases(id)[0]["crashes"], 1);
  EXPECT_EQ(cases(id)[0]["state"], "queued");
}

TEST_F(ServiceTest, CaseThatTakesTooMuchMemoryFailsAndSaysHowMuch) {
  limits_.memory_mb = 100;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  executor_.take_memory(200);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "failed");
  EXPECT_EQ(cases(id)[0]["message"], "it took 200 MB of memory; the limit is 100");
}

TEST_F(ServiceTest, CaseThatTakesTooLongFails) {
  limits_.wall_time = 1h;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.advance(1h + 1s);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "failed");
  EXPECT_EQ(cases(id)[0]["message"], "it took longer than the limit of 3600 s");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
}

TEST_F(ServiceTest, ClockThatJumpsBackCostsNoRun) {
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.advance(-12h);
  service_->tick();
  clock_.advance(12h + JobQueue::kHeartbeat);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["attempt"], 1);
  EXPECT_THAT(executor_.running, ElementsAre("run 1"));
}

TEST_F(ServiceTest, CaseThatCannotBeStartedStaysInTheQueue) {
  executor_.is_broken = true;
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  EXPECT_THROW(service_->tick(), std::runtime_error);
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["message"], "could not be started: no process to be had");
  executor_.is_broken = false;
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
}

TEST_F(ServiceTest, SecondDaemonOnOneDirectoryIsRefused) {
  EXPECT_THROW(DataDirectory{directory_.path()}, std::runtime_error);
}

}  // namespace
}  // namespace capstan
