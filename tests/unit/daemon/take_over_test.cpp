#include "runner/daemon/take_over.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "runner/store/schema.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using ::testing::ElementsAre;

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

TEST_F(ServiceTest, StartSweepsOrphansThatHoldNothingAndKeepsTheOthers) {
  const RunDirectory empty = data_.run("00000000deadbeef"), worth = data_.run("00000000cafecafe");
  for (const RunDirectory& orphan : {empty, worth}) orphan.prepare("{}");
  std::ofstream(worth.checkpoint_paths()[0]) << "hours of work";
  std::filesystem::create_directories(data_.path() / "runs" / "my notes");
  restart();
  EXPECT_FALSE(std::filesystem::exists(empty.path()));
  EXPECT_TRUE(std::filesystem::exists(worth.path()));
  EXPECT_TRUE(std::filesystem::exists(data_.path() / "runs" / "my notes"));
}

TEST_F(ServiceTest, StartSweepsWhatAKilledRunLeftHalfWritten) {
  submit({{"Ca", {0.25}}});
  const std::filesystem::path half = directory_of("run 1").checkpoint_paths()[0].string() + ".partial";
  std::ofstream(half) << "half of i";
  restart();
  EXPECT_FALSE(std::filesystem::exists(half));
}

/// The database is changed so that an earlier program (numerics version 0) seems to have queued the case.
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

}  // namespace
}  // namespace capstan
