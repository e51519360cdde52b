#include "runner/daemon/record_run.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <fstream>

#include "solver/case/run_cost.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

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

TEST_F(ServiceTest, ProgressFollowsTheHistory) {
  const std::string id = submit({{"Ca", {0.25}}, {"E_b", {0.01}}, {"c0", {0, 1}}});
  write_history("run 1", "{\"kt\":15}\n");
  service_->tick();
  const double first = case_cost(case_of("run 1")), second = case_cost(case_of("run 2"));
  EXPECT_EQ(cases(id)[0]["progress"], 0.5);
  EXPECT_NEAR(study(id)["progress"], 0.5 * first / (first + second), 1e-6);
}

TEST_F(ServiceTest, ProgressWeighsCasesByWhatTheyCost) {
  const std::string id = submit({{"V", {1, 4}}, {"Ca", {0.25}}});
  const double equal = case_cost(case_of("run 1")), unequal = case_cost(case_of("run 2"));
  ASSERT_LT(equal, 0.8 * unequal);  // no viscosity field at V = 1
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
  EXPECT_THAT(service_->why_nothing_starts(), ::testing::HasSubstr("cannot be used"));
  std::filesystem::create_directory(data_.runs());
  EXPECT_EQ(service_->why_nothing_starts(), "");
}

/// While an object of this class exists, this process cannot open files.
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
  std::filesystem::create_directory(result);  // a directory cannot be read as a file
  executor_.exit("run 1", 0);
  EXPECT_THROW(service_->tick(),
               std::filesystem::filesystem_error);  // of the next start, which is tried at once
  EXPECT_EQ(cases(id)[0]["state"], "queued");
  EXPECT_EQ(cases(id)[0]["crashes"], 0);
  EXPECT_THAT(cases(id)[0]["message"].get<std::string>(), ::testing::HasSubstr("result.json"));
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

TEST_F(ServiceTest, EndedCaseKeepsNoMoreCheckpointsThanItNeeds) {
  service_->submit(sample_study("kept", {{"Ca", {0.25, 0.75}}}));
  service_->tick();
  for (const char* run : {"run 1", "run 2"})
    for (const auto& file : directory_of(run).checkpoint_paths()) std::ofstream(file) << "state";
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
