#include "runner/daemon/service.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <atomic>
#include <fstream>
#include <random>
#include <thread>

#include "runner/queries/why.hpp"
#include "runner/store/schema.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;
using namespace std::chrono_literals;

class ServiceTest : public ServiceFixture {
 protected:
  static constexpr auto kHeartbeat = JobQueue::kLease / JobQueue::kHeartbeats;

  std::string submit(const nlohmann::json& axes) {
    const std::string id = service_->submit(sample_study("study", axes)).study_id;
    service_->tick();
    return id;
  }
  Case case_of(const RunHandle& run) {
    return parse_case(nlohmann::json::parse(std::ifstream(directory_of(run).case_file()))).value.value();
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
  const std::string id = submit({{"Ca", {0.25}}, {"E_b", {0.01}}, {"c0", {0, 1}}});
  write_history("run 1", "{\"kt\":15}\n");
  service_->tick();
  const double first = run_cost(case_of("run 1")), second = run_cost(case_of("run 2"));
  EXPECT_EQ(cases(id)[0]["progress"], 0.5);
  EXPECT_NEAR(study(id)["progress"], 0.5 * first / (first + second), 1e-6);
}

TEST_F(ServiceTest, ProgressWeighsCasesByWhatTheyCost) {
  const std::string id = submit({{"V", {1, 4}}, {"Ca", {0.25}}});
  const double equal = run_cost(case_of("run 1")), unequal = run_cost(case_of("run 2"));
  ASSERT_LT(equal, 0.8 * unequal);  // without a viscosity field
  complete("run 1", "tumbling");
  service_->tick();
  EXPECT_NEAR(study(id)["progress"], equal / (equal + unequal), 1e-6);
}

TEST_F(ServiceTest, RecordedHistoryIsTheFileAsTheLastAttemptLeftIt) {
  const std::string id = submit({{"Ca", {0.25}}});
  write_history("run 1", "{\"kt\":1}\n{\"kt\":2}\n{\"kt\":3}\n");
  service_->tick();
  write_history("run 1", "{\"kt\":1}\n{\"kt\":2.5}\n");
  complete("run 1", "tumbling");
  service_->tick();
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(find_history(*reader, cases(id)[0]["id"]).value()["kt"], nlohmann::ordered_json({1.0, 2.5}));
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

/// Before it has its handlers a process may end by the signal, or in whatever other way.
TEST_F(ServiceTest, RunThatWasAskedToStopIsInterruptedHoweverItEnds) {
  for (const ProcessEnd end :
       {ProcessEnd{ProcessEnd::How::signalled, 15}, ProcessEnd{ProcessEnd::How::exited, 143},
        ProcessEnd{ProcessEnd::How::exited, 1}, ProcessEnd{ProcessEnd::How::exited, 0}}) {
    const std::string id = submit({{"Ca", {0.25}}});
    ASSERT_THAT(executor_.running, SizeIs(1));
    service_->drain();
    service_->tick();
    executor_.end(executor_.running[0], end);
    service_->tick();
    EXPECT_EQ(cases(id)[0]["state"], "queued");
    EXPECT_EQ(cases(id)[0]["crashes"], 0);
    restart();
  }
}

TEST_F(ServiceTest, CancelledRunThatEndsByTheSignalIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->cancel(id);
  service_->tick();
  executor_.end("run 1", {ProcessEnd::How::signalled, 15});
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "cancelled");
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
  executor_.is_stopped = true;  // and has not come to compute again yet
  clock_.jump(12h);
  service_->tick();
  clock_.advance(kHeartbeat);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["attempt"], 1);
  EXPECT_THAT(executor_.running, ElementsAre("run 1"));
}

TEST_F(ServiceTest, RunThatStandsStillLosesItsLeaseAndIsKilled) {
  const std::string id = submit({{"Ca", {0.25}}});
  executor_.is_stopped = true;
  for (int beat = 0; beat < 6; ++beat) {
    clock_.advance(kHeartbeat);
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

TEST_F(ServiceTest, CaseThatTakesTooLongIsAskedForACheckpointAndFails) {
  limits_.wall_time = 1h;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.advance(1h + 1s);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
  ASSERT_EQ(executor_.asked_to_stop.size(), 1u);
  executor_.end(executor_.asked_to_stop.front(), {ProcessEnd::How::exited, kExitInterrupted});
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "failed");
  EXPECT_EQ(cases(id)[0]["message"], "it took longer than the limit of 3600 s");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
}

TEST_F(ServiceTest, CaseThatTakesTooLongAndDoesNotStopIsKilledAndFails) {
  limits_.wall_time = 1h;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  for (auto passed : {3601s, 9s}) {
    clock_.advance(passed);
    service_->tick();
  }
  EXPECT_EQ(executor_.killed.size(), 1u);
  EXPECT_EQ(cases(id)[0]["state"], "failed");
  EXPECT_EQ(cases(id)[0]["message"], "it took longer than the limit of 3600 s");
}

TEST_F(ServiceTest, ClockThatJumpsCostsNoRun) {
  const std::string id = submit({{"Ca", {0.25}}});
  for (auto jump : {-12h, 24h, -12h}) {
    clock_.jump(jump);
    service_->tick();
    clock_.advance(kHeartbeat);
    service_->tick();
  }
  EXPECT_EQ(cases(id)[0]["attempt"], 1);
  EXPECT_THAT(executor_.running, ElementsAre("run 1"));
}

TEST_F(ServiceTest, CaseThatCannotBeStartedStaysInTheQueue) {
  executor_.is_broken = true;
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  EXPECT_THROW(service_->tick(), std::runtime_error);
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["message"], "could not be started: no process to be had");
  EXPECT_EQ(cases(id)[0]["attempt"], 0);
  executor_.is_broken = false;
  clock_.advance(JobQueue::kBackOff);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
}

TEST_F(ServiceTest, ClockThatJumpsIsNoTimeThatARunTook) {
  limits_.wall_time = 1h;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.jump(24h);
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

TEST_F(ServiceTest, RunThatIgnoresTheEndOfTheDaemonIsKilledInTime) {
  static_assert(Service::kGrace + 1s <= 10s);
  submit({{"Ca", {0.25}}});
  service_->drain();
  service_->tick();
  EXPECT_THAT(executor_.killed, IsEmpty());
  EXPECT_FALSE(service_->has_ended());
  clock_.advance(Service::kGrace + 1ms);
  service_->tick();
  EXPECT_THAT(executor_.killed, ElementsAre("run 1"));
  EXPECT_TRUE(service_->has_ended() && service_->is_idle());
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

TEST_F(ServiceTest, StartSweepsOrphansThatHoldNothingAndKeepsTheOthers) {
  const RunDirectory empty = data_.run("00000000deadbeef"), worth = data_.run("00000000cafecafe");
  for (const RunDirectory& orphan : {empty, worth}) orphan.prepare("{}");
  std::ofstream(worth.path() / "checkpoint-a.h5") << "hours of work";
  std::filesystem::create_directories(data_.path() / "runs" / "my notes");
  restart();
  EXPECT_FALSE(std::filesystem::exists(empty.path()));
  EXPECT_TRUE(std::filesystem::exists(worth.path()));
  EXPECT_TRUE(std::filesystem::exists(data_.path() / "runs" / "my notes"));
}

TEST_F(ServiceTest, StartSweepsWhatAKilledRunLeftHalfWritten) {
  submit({{"Ca", {0.25}}});
  const std::filesystem::path half = directory_of("run 1").path() / "checkpoint-a.h5.partial";
  std::ofstream(half) << "half of i";
  restart();
  EXPECT_FALSE(std::filesystem::exists(half));
}

TEST_F(ServiceTest, DamagedCaseFileIsWrittenAgain) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  const RunDirectory directory = data_.run(cases(id)[0]["id"]);
  directory.prepare("half of");
  service_->tick();
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(directory.case_file())),
            nlohmann::json(cases(id)[0]["parameters"]));
}

TEST_F(ServiceTest, StudiesSubmittedAtOnceAreAllKept) {
  std::vector<std::thread> clients;
  for (int client = 0; client < 8; ++client)
    clients.emplace_back([this, client] {
      for (int i = 0; i < 20; ++i)
        service_->submit(sample_study("study", {{"Ca", {0.1 + client, 0.101 + 0.001 * i}}}));
    });
  for (std::thread& client : clients) client.join();
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(list_studies(*reader, {}).items.size(), 160u);
}

TEST_F(ServiceTest, ReusedKeyIsRefusedAndConcernsNobodyElse) {
  std::vector<std::thread> clients;
  std::atomic<int> refused = 0;
  for (int client = 0; client < 8; ++client)
    clients.emplace_back([this, client, &refused] {
      try {
        service_->submit(sample_study("study", {{"Ca", {0.1 + client}}}), client < 4 ? "key" : "");
      } catch (const KeyReused&) {
        ++refused;
      }
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(refused, 3);
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(list_studies(*reader, {}).items.size(), 5u);
}

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

TEST_F(ServiceTest, ReasonsOfAStudyAreCounted) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.1, 0.2, 0.3, 0.4}}})).study_id;
  service_->tick();
  executor_.exit("run 1", 2);
  executor_.exit("run 2", 2);
  service_->pause(id, true);
  service_->tick();
  const auto reasons = why_study(*service_->reader(), id).value()["reasons"];
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0]["cases"], 2);
  EXPECT_EQ(reasons[0]["reason"], "queued; the study is paused: capstan resume " + id);
  EXPECT_EQ(reasons[1]["cases"], 2);
  EXPECT_EQ(reasons[1]["reason"],
            "failed: the solver refused the case (case " + std::string(cases(id)[0]["id"]) + ")");
  EXPECT_FALSE(why_study(*service_->reader(), "nobody-0000"));
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

TEST_F(ServiceTest, RetryAtAnInvalidFidelityChangesNothingAndSaysAllFaults) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  executor_.exit("run 1", 3);
  service_->tick();
  const Issues issues = service_->retry_at(id, {{"nodes", 7}, {"colour", "red"}});
  EXPECT_THAT(issues, SizeIs(2));
  EXPECT_EQ(cases(id)[0]["state"], "diverged");
}

TEST_F(ServiceTest, RetryAtAnInvalidFidelityIsAFaultWhereNothingHasFailed) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  EXPECT_THAT(service_->retry_at(id, "finest"), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, nullptr), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, {{"colour", "red"}}), SizeIs(1));
  EXPECT_THAT(service_->retry_at(id, "fine"), IsEmpty());
  service_->cancel(id);
  EXPECT_THAT(service_->retry_at(id, "finest"), SizeIs(1));
}

/// As a database looks in which an earlier program has queued a case.
TEST_F(ServiceTest, QueuedCaseOfAnEarlierNumericsVersionIsReplacedAtTheStart) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  const std::string present = cases(id)[0]["id"], earlier = "00000000deadbeef";
  Database database(data_.database(), Database::Access::write);
  database.execute_script("PRAGMA foreign_keys = OFF");
  database.execute("UPDATE cases SET id = ?, numerics = 0", earlier);
  database.execute("UPDATE study_cases SET case_id = ?", earlier);
  database.execute_script(kRecount);
  restart();
  EXPECT_EQ(cases(id)[0]["id"], present);
  EXPECT_EQ(cases(id)[0]["replaces"], earlier);
  EXPECT_EQ(study(id)["cases"]["queued"], 1);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(find_case(*reader, earlier).value()["state"], "cancelled");
}

TEST_F(ServiceTest, NothingIsStartedOnAFullDiskAndWhySaysSo) {
  const std::string id = service_->submit(sample_study("study", {{"Ca", {0.25}}})).study_id;
  service_->keep_free(std::filesystem::space(data_.runs()).capacity);
  service_->tick();
  EXPECT_THAT(executor_.running, IsEmpty());
  EXPECT_THAT(service_->why_nothing_starts(), testing::HasSubstr("are free in"));
  service_->keep_free(0);
  service_->tick();
  EXPECT_THAT(executor_.running, SizeIs(1));
  EXPECT_EQ(service_->why_nothing_starts(), "");
}

TEST_F(ServiceTest, ErrorOnAFullDiskIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->keep_free(std::filesystem::space(data_.runs()).capacity);
  executor_.exit("run 1", 1);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
  EXPECT_EQ(cases(id)[0]["message"], "the disk was full");
}

TEST_F(ServiceTest, ErrorWithoutTheDirectoryOfTheRunIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  std::filesystem::remove_all(data_.runs());
  executor_.exit("run 1", 1);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
  EXPECT_THAT(service_->why_nothing_starts(), testing::HasSubstr("cannot be used"));
  std::filesystem::create_directory(data_.runs());
  EXPECT_EQ(service_->why_nothing_starts(), "");
}

/// No file can be opened while it lasts.
class NoDescriptors {
 public:
  NoDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit none{0, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
  }
  ~NoDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(ServiceTest, ShortageOfDescriptorsAtTheEndOfARunIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  write_history("run 1", "{\"kt\":30}\n");
  complete("run 1", "tumbling");
  {
    const NoDescriptors shortage;
    EXPECT_THROW(service_->tick(), std::filesystem::filesystem_error);
  }
  EXPECT_EQ(cases(id)[0]["state"], "running");
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "done");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
}

TEST_F(ServiceTest, ResultThatCannotBeReadIsReadLater) {
  const std::string id = submit({{"Ca", {0.25}}});
  const std::filesystem::path result = directory_of("run 1").result_file();
  std::filesystem::create_directory(result);  // cannot be read
  executor_.exit("run 1", 0);
  EXPECT_THROW(service_->tick(), std::filesystem::filesystem_error);  // at once the next start is tried
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
  EXPECT_THAT(cases(id)[0]["message"].get<std::string>(), testing::HasSubstr("result.json"));
  std::filesystem::remove(result);
  clock_.advance(JobQueue::kBackOff);
  complete("run 1", "tumbling");
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "done");
}

TEST_F(ServiceTest, RunThatCannotBeRecordedHoldsNobodyUp) {
  const std::string id = submit({{"Ca", {0.25, 0.5}}});
  std::filesystem::create_directory(directory_of("run 1").result_file());
  executor_.exit("run 1", 0);
  complete("run 2", "tumbling");
  EXPECT_THROW(service_->tick(), std::filesystem::filesystem_error);
  EXPECT_EQ(cases(id)[1]["state"], "done");
}

TEST_F(ServiceTest, UnreadableHistoryLeavesTheRowsThatAreThere) {
  const std::string id = submit({{"Ca", {0.25}}});
  write_history("run 1", "{\"kt\":1}\n{\"kt\":2}\n{\"kt\":3}\n");
  service_->tick();
  write_history("run 1", std::string(40, '\0') + "\n");
  complete("run 1", "tumbling");
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "done");
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(find_history(*reader, cases(id)[0]["id"]).value()["kt"], nlohmann::ordered_json({1.0, 2.0, 3.0}));
}

/// Jumps by a day between any two looks at it.
class RestlessClock : public Clock {
 public:
  Time now() const override { return time_ + std::chrono::hours(24) * (random_() % 3); }
  std::chrono::milliseconds elapsed() const override { return 0ms; }

 private:
  const Time time_{std::chrono::hours(24 * 365 * 50)};
  mutable std::mt19937 random_;
};

TEST(RestlessClock, CostsNoRun) {
  const TemporaryDirectory directory;
  const DataDirectory data(directory.path());
  const RestlessClock clock;
  FakeExecutor executor;
  Service service(data, executor, clock, 4);
  service.submit(sample_study("study", {{"Ca", {0.1, 0.2, 0.3, 0.4}}}));
  for (int i = 0; i < 200; ++i) service.tick();
  EXPECT_THAT(executor.running, SizeIs(4));
  EXPECT_THAT(executor.directories, SizeIs(4));
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

TEST(NetworkFileSystem, IsKnownByItsNumber) {
  EXPECT_EQ(network_file_system(0x6969), "NFS");
  EXPECT_EQ(network_file_system(static_cast<int>(0xFF534D42)), "CIFS");
  EXPECT_EQ(network_file_system(0xEF53), "");  // ext4
}

TEST_F(ServiceTest, SecondDaemonOnOneDirectoryIsRefused) {
  EXPECT_THROW(DataDirectory{directory_.path()}, std::runtime_error);
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

TEST_F(ServiceTest, DaemonKilledBetweenTheRowsAndTheDirectoriesOfADeletedStudyHasASuccessorThatGoesOn) {
  const std::string id = service_->submit(sample_study("gone", {{"Ca", {0.25}}})).study_id;
  service_->tick();
  complete("run 1", "tumbling");
  service_->tick();
  service_->remove(id);
  {
    Database database(data_.database(), Database::Access::write);
    EXPECT_EQ(delete_unwanted_cases(database, 10).size(), 1u);
  }
  restart();
  EXPECT_TRUE(std::filesystem::exists(directory_of("run 1").path()));
  service_->tick();
  EXPECT_FALSE(std::filesystem::exists(directory_of("run 1").path()));
}

TEST_F(ServiceTest, EndedCaseKeepsNoMoreCheckpointsThanItNeeds) {
  service_->submit(sample_study("kept", {{"Ca", {0.25, 0.75}}}));
  service_->tick();
  for (const char* run : {"run 1", "run 2"})
    for (const char* file : {"checkpoint-a.h5", "checkpoint-b.h5"})
      std::ofstream(directory_of(run).path() / file) << "state";
  const auto checkpoints = [&](const char* run) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(directory_of(run).path()))
      count += entry.path().extension() == ".h5" ? 1 : 0;
    return count;
  };
  complete("run 1", "tumbling");
  std::ofstream(directory_of("run 2").result_file()) << R"({"stop": "diverged", "motion": null})";
  executor_.exit("run 2", 3);
  service_->tick();
  EXPECT_EQ(checkpoints("run 1"), 1);
  EXPECT_EQ(checkpoints("run 2"), 0);
}

}  // namespace
}  // namespace capstan
