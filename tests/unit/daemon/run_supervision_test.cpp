#include "runner/daemon/run_supervision.hpp"

#include <gmock/gmock.h>

#include <random>

#include "solver/run_directory/exit_code.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using namespace std::chrono_literals;

TEST_F(ServiceTest, CancelledRunIsAskedToStopAndThenKilled) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->cancel(id);
  service_->tick();
  EXPECT_THAT(executor_.asked_to_stop, ElementsAre("run 1"));
  service_->tick();
  EXPECT_THAT(executor_.asked_to_stop, SizeIs(1));
  EXPECT_THAT(executor_.killed, IsEmpty());
  clock_.advance(RunSupervision::kGrace + 1ms);
  service_->tick();
  EXPECT_THAT(executor_.killed, ElementsAre("run 1"));
  EXPECT_EQ(cases(id)[0]["state"], "cancelled");
}

TEST_F(ServiceTest, RunKilledForNotStoppingIsNoCrash) {
  const std::string id = submit({{"Ca", {0.25}}});
  service_->drain();
  service_->tick();
  clock_.advance(RunSupervision::kGrace + 1ms);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
}

/// A process that has not installed its handlers yet is killed by the signal, or ends in another way.
TEST_F(ServiceTest, RunThatWasAskedToStopIsInterruptedHoweverItEnds) {
  for (const ProcessEnd& end :
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

TEST_F(ServiceTest, SleepOfTheMachineCostsNoRun) {
  const std::string id = submit({{"Ca", {0.25}}});
  executor_.is_stopped = true;  // it has not computed since the machine woke up
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
  for (int heartbeat = 0; heartbeat < JobQueue::kHeartbeats; ++heartbeat) {
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

TEST_F(ServiceTest, ClockThatJumpsIsNoTimeThatARunTook) {
  limits_.wall_time = 1h;
  restart();
  const std::string id = submit({{"Ca", {0.25}}});
  clock_.jump(24h);
  service_->tick();
  EXPECT_EQ(cases(id)[0]["state"], "running");
}

TEST_F(ServiceTest, RunThatIgnoresTheEndOfTheDaemonIsKilledInTime) {
  static_assert(RunSupervision::kGrace + 1s <= 10s);
  submit({{"Ca", {0.25}}});
  service_->drain();
  service_->tick();
  EXPECT_THAT(executor_.killed, IsEmpty());
  EXPECT_FALSE(service_->has_ended());
  clock_.advance(RunSupervision::kGrace + 1ms);
  service_->tick();
  EXPECT_THAT(executor_.killed, ElementsAre("run 1"));
  EXPECT_TRUE(service_->has_ended() && service_->is_idle());
}

/// The time of day jumps by up to two days between two calls.
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
  FakeExecutor executor(4);
  Service service(data, executor, clock);
  service.submit(sample_study("study", {{"Ca", {0.1, 0.2, 0.3, 0.4}}}));
  for (int i = 0; i < 200; ++i) service.tick();
  EXPECT_THAT(executor.running, SizeIs(4));
  EXPECT_THAT(executor.directories, SizeIs(4));
}

}  // namespace
}  // namespace capstan
