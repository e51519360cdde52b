#include "runner/recording/outcome.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "runner/recording/history.hpp"
#include "tests/support/source_directory.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

class OutcomeTest : public ::testing::Test {
 protected:
  void write(const char* file, const std::string& text) { std::ofstream(directory_.path() / file) << text; }
  RunOutcome exited_with(int code) {
    return outcome_of({ProcessEnd::How::exited, code}, RunDirectory(directory_.path()));
  }
  RunOutcome killed_by(int signal) {
    return outcome_of({ProcessEnd::How::signalled, signal}, RunDirectory(directory_.path()));
  }

  TemporaryDirectory directory_;
};

TEST_F(OutcomeTest, AnswerIsDone) {
  for (const char* stop : {"reached_end", "classified", "steady"}) {
    write("result.json", std::string("{\"stop\":\"") + stop + "\",\"motion\":\"tumbling\"}");
    const RunOutcome outcome = exited_with(0);
    EXPECT_EQ(outcome.ending, RunEnding::done);
    EXPECT_EQ((*outcome.result)["motion"], "tumbling");
  }
}

TEST_F(OutcomeTest, NumericalFailureIsDivergedWithItsMessage) {
  write("result.json", R"({"stop": "not_converged", "message": "no flow at kt = 3"})");
  const RunOutcome outcome = exited_with(3);
  EXPECT_EQ(outcome.ending, RunEnding::diverged);
  EXPECT_EQ(outcome.message, "no flow at kt = 3");
}

TEST_F(OutcomeTest, ARunWithoutAnAnswerHasNoMotion) {
  for (const char* stop : {"diverged", "not_converged"}) {
    write("result.json", std::string("{\"stop\":\"") + stop + "\",\"motion\":\"tank_treading\"}");
    EXPECT_TRUE((*exited_with(3).result)["motion"].is_null()) << stop;
  }
}

TEST_F(OutcomeTest, PublishedResultCountsHoweverTheProcessEndedAfterwards) {
  write("result.json", R"({"stop": "reached_end"})");
  EXPECT_EQ(killed_by(SIGKILL).ending, RunEnding::done);
  EXPECT_EQ(outcome_of({}, RunDirectory(directory_.path())).ending, RunEnding::done);
}

TEST_F(OutcomeTest, RefusedCaseFailsWithItsLog) {
  write("log", "/V  is 0\n");
  const RunOutcome outcome = exited_with(2);
  EXPECT_EQ(outcome.ending, RunEnding::failed);
  EXPECT_NE(outcome.message.find("/V  is 0"), std::string::npos);
}

TEST_F(OutcomeTest, InterruptionGoesBackToTheQueue) {
  EXPECT_EQ(exited_with(75).ending, RunEnding::interrupted);
  EXPECT_EQ(outcome_of({}, RunDirectory(directory_.path())).ending, RunEnding::interrupted);
}

TEST_F(OutcomeTest, AnyOtherEndIsACrash) {
  EXPECT_EQ(exited_with(1).ending, RunEnding::crashed);
  EXPECT_EQ(exited_with(0).ending, RunEnding::crashed);  // exit code 0 without result.json
  const RunOutcome outcome = killed_by(SIGSEGV);
  EXPECT_EQ(outcome.ending, RunEnding::crashed);
  EXPECT_EQ(outcome.message, "killed by signal 11 (Segmentation fault)");
}

TEST_F(OutcomeTest, DamagedResultCountsAsMissing) {
  for (const char* text : {"", "{\"stop\":", "[]", "null"}) {
    write("result.json", text);
    EXPECT_EQ(exited_with(0).ending, RunEnding::crashed) << text;
  }
}

TEST_F(OutcomeTest, ResultOfALaterFormatFailsTheCase) {
  write("result.json", R"({"format": 2, "stop": "reached_end"})");
  EXPECT_EQ(exited_with(0).ending, RunEnding::failed);
  EXPECT_EQ(exited_with(0).message, "result.json has format 2, this program reads format 1");
}

/// tests/reference/run_directory_1 was written by a process of format 1.
TEST(OldRunDirectory, CompleteOneIsRecorded) {
  const RunOutcome outcome =
      outcome_of({}, RunDirectory(source_directory() / "tests/reference/run_directory_1"));
  EXPECT_EQ(outcome.ending, RunEnding::done);
  EXPECT_EQ((*outcome.result)["motion"], "undecided");
  HistoryTail history(source_directory() / "tests/reference/run_directory_1/history.jsonl");
  EXPECT_EQ(history.read_new().records.size(), 11u);
}

TEST_F(OutcomeTest, LongLogIsCutToItsLastLines) {
  write("log", std::string(5000, 'x') + "\nlast words\n");
  EXPECT_EQ(exited_with(1).message, "exit code 1\nlast words");
}

}  // namespace
}  // namespace capstan
