// The real daemon on a data directory of format 1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/support/campaign.hpp"
#include "tests/support/old_database.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

class OldData : public ::testing::Test {
 protected:
  void SetUp() override { make_old_database(data_.path() / "capstan.sqlite"); }

  TemporaryDirectory data_;
};

TEST_F(OldData, IsServedWithAllResultsAndTheDaemonGoesOnAndTakesANewStudy) {
  Daemon daemon(data_.path());
  Client client(daemon.url());
  const ordered_json kept = client.get("/v1/studies/kept-8a8f");
  EXPECT_EQ(kept["cases"]["done"], 2);
  EXPECT_EQ(kept["cases"]["failed"], 4);
  EXPECT_EQ(kept["cases"]["diverged"], 2);
  EXPECT_EQ(kept["description"], "of format 1");
  const ordered_json tumbling = client.get("/v1/studies/kept-8a8f/cases?motion=tumbling")["cases"];
  ASSERT_EQ(tumbling.size(), 1u);
  EXPECT_EQ(tumbling[0]["id"], "37a6223175482b37");
  const ordered_json history = client.get("/v1/cases/37a6223175482b37/history");
  EXPECT_EQ(history["kt"].size(), 10u);
  EXPECT_EQ(client.get("/v1/cases/4162bae35bea7a4b")["attempts"].size(), 2u);
  EXPECT_EQ(client.get("/v1/studies/dropped-78c0")["cases"]["cancelled"], 2);

  // The study that was running when the old daemon was killed: three of its cases wait for a signal without
  // end.
  const ordered_json other = wait_for(client, "/v1/studies/other-58cb", [](const ordered_json& study) {
    return study["cases"]["done"] == 3 && study["cases"]["running"] == 3;
  });
  EXPECT_EQ(other["motions"]["tumbling"], 3);
  client.post("/v1/studies/other-58cb/cancel", "");
  const std::string id =
      client.post("/v1/studies", study_document("new", {{"Ca", {0.25, 0.75}}}).dump())["id"];
  wait_for_cases(client, id, "done", 2);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  EXPECT_EQ(broken_promise(data_.path()), "");
}

TEST_F(OldData, IsRepairedByTheDoctor) {
  const std::string doctor = "doctor --data " + data_.path().string();
  std::filesystem::create_directory(data_.path() / "runs");
  EXPECT_EQ(run_capstan(doctor + " --repair").exit_code, 0);
  EXPECT_EQ(run_capstan(doctor).output, "all is well\n");
}

}  // namespace
}  // namespace capstan
