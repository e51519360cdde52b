// The real `capstan solve` as a process: killed, terminated, on a full disk, it is resumed to the same
// answer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "solver/case/content_id.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/solve_process.hpp"
#include "tests/support/source_directory.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A red blood cell by boundary integrals with a checkpoint after each step; takes some tenths of a second.
const char* const kQuick =
    R"({"shape": "biconcave", "law": "skalak", "C": 5, "fluid": "stokes", "Ca": 0.2, "V": 2,
  "fidelity": {"nodes": 162}, "until": {"kt": 6}, "outputs": {"history_every": 0.1, "checkpoint_every": 1}})";

class SolveTest : public ::testing::Test {
 protected:
  fs::path write_case(const std::string& text) {
    overwrite(root_.path() / "case.json", text);
    return root_.path() / "case.json";
  }

  /// A red blood cell with bending and a viscosity ratio on a lattice; takes some seconds.
  fs::path cell() {
    return write_case(R"({"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4, "Ca": 0.4,
      "fidelity": {"preset": "fast", "dx": 0.4, "nodes": 162}, "until": {"kt": 10},
      "outputs": {"checkpoint_every": 3, "history_every": 0.2}})");
  }

  fs::path directory(const std::string& name) const { return root_.path() / name; }

  /// Runs to the end. Returns the exit code.
  int solve(const fs::path& case_file, const std::string& name) {
    return SolveProcess(case_file, directory(name)).wait();
  }

  std::string history(const std::string& name) const { return file_bytes(directory(name) / "history.jsonl"); }
  nlohmann::json result(const std::string& name) const {
    return nlohmann::json::parse(file_bytes(directory(name) / "result.json"));
  }
  std::string log(const std::string& name) const { return file_bytes(directory(name + ".log")); }

  /// History, result and index of the shapes, except for time and memory.
  void expect_same_answer(const std::string& name, const std::string& other) const {
    EXPECT_EQ(history(name), history(other));
    nlohmann::json a = result(name), b = result(other);
    for (const char* cost : {"seconds", "peak_memory_mb"}) a["cost"].erase(cost), b["cost"].erase(cost);
    for (nlohmann::json* result : {&a, &b})
      if ((*result)["error"].contains("companion")) (*result)["error"]["companion"].erase("seconds");
    EXPECT_EQ(a, b);
    EXPECT_EQ(file_bytes(directory(name) / "shapes.xdmf2"), file_bytes(directory(other) / "shapes.xdmf2"));
  }

 private:
  TemporaryDirectory root_;
};

// An undisturbed run makes about 1200 writes to its directory, so the kills are spread over all of it. Their
// number is fixed, so the test ends even if a killed run makes no progress.
TEST_F(SolveTest, RunKilledAgainAndAgainHasTheSameHistoryAndResult) {
  const fs::path case_file = cell();
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  std::mt19937 generator(20240613);
  std::uniform_int_distribution<int> writes(1, 200);
  int kills = 0;
  for (int attempt = 0; attempt < 12; ++attempt) {
    SolveProcess process(case_file, directory("killed"));
    process.wait_for_writes(writes(generator));
    process.send(SIGKILL);
    kills += process.wait() == -SIGKILL;
  }
  EXPECT_GE(kills, 8);
  EXPECT_EQ(solve(case_file, "killed"), 0);
  EXPECT_THAT(log("killed"), HasSubstr("resumed at step"));
  expect_same_answer("killed", "undisturbed");
}

TEST_F(SolveTest, TerminatedRunExitsWith75AndIsResumed) {
  const fs::path case_file = cell();
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  for (int signal : {SIGTERM, SIGUSR1, SIGHUP}) {
    SolveProcess process(case_file, directory("terminated"));
    process.wait_for_writes(40);
    process.send(signal);
    EXPECT_EQ(process.wait(), 75);
    EXPECT_FALSE(fs::exists(directory("terminated") / "result.json"));
  }
  EXPECT_EQ(solve(case_file, "terminated"), 0);
  expect_same_answer("terminated", "undisturbed");
}

TEST_F(SolveTest, RunAtItsWallTimeExitsWith75AndIsResumed) {
  const fs::path case_file = write_case(kQuick);
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_EQ(SolveProcess(case_file, directory("limited"), {"--wall-time", "1e-9"}).wait(), 75);
  EXPECT_THAT(log("limited"), HasSubstr("resumed at step 1, kt = "));
  ASSERT_EQ(solve(case_file, "limited"), 0);
  EXPECT_THAT(log("limited"), HasSubstr("resumed at step 2, kt = "));
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  expect_same_answer("limited", "undisturbed");
}

TEST_F(SolveTest, AnAnswerHasErrorsFromItsCompanionWhichIsCompleteInItsOwnDirectory) {
  ASSERT_EQ(solve(write_case(kQuick), "run"), 0);
  const nlohmann::json error = result("run")["error"];
  EXPECT_GT(error["Q"], 0);
  EXPECT_GT(error["D_xy"], 0);
  EXPECT_EQ(error["companion"]["nodes"], 42);
  EXPECT_EQ(error["companion"]["stop"], "reached_end");
  const fs::path companion = directory("run") / "rungs/42";
  EXPECT_TRUE(fs::exists(companion / "result.json"));
  EXPECT_NE(fs::exists(companion / "checkpoint-a.h5"), fs::exists(companion / "checkpoint-b.h5"));
  EXPECT_FALSE(fs::is_symlink(directory("run") / "history.jsonl"));
}

TEST_F(SolveTest, ACaseWithoutCompanionSaysThatItsErrorIsUnknown) {
  std::string alone = kQuick;
  alone.insert(1, R"("companion": false, )");
  ASSERT_EQ(solve(write_case(alone), "alone"), 0);
  EXPECT_TRUE(result("alone")["error"]["Q"].is_null());
  EXPECT_EQ(result("alone")["error"]["unknown"], "the case asks for no companion");
  EXPECT_EQ(result("alone")["confirmed"], false);
  EXPECT_FALSE(fs::exists(directory("alone") / "rungs"));
}

/// A sphere that climbs to 642 nodes.
const char* const kClimb =
    R"({"Ca": 0.1, "V": 2, "E_b": 0.01, "fluid": "stokes", "fidelity": {"error": 0.005},
  "until": {"kt": 4}, "outputs": {"history_every": 0.1, "shapes_every": 1, "checkpoint_every": 1}})";

TEST_F(SolveTest, AnErrorAskedForIsMetByTheFirstRungWhoseEstimateIsSmaller) {
  ASSERT_EQ(solve(write_case(kClimb), "climb"), 0);
  const nlohmann::json error = result("climb")["error"];
  EXPECT_EQ(error["met"], true);
  EXPECT_LE(error["Q"], 0.005);
  EXPECT_EQ(error["asked"], 0.005);
  const std::string nodes = std::to_string(error["nodes"].get<int>());
  EXPECT_EQ(history("climb"), file_bytes(directory("climb") / "rungs" / nodes / "history.jsonl"));
  EXPECT_TRUE(fs::exists(directory("climb") / "shapes/0004.h5"));
  EXPECT_EQ(result("climb")["case"]["fidelity"]["error"], 0.005);
}

TEST_F(SolveTest, AClimbThatIsInterruptedAgainAndAgainHasTheSameAnswer) {
  const fs::path case_file = write_case(kClimb);
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  int interruptions = 0;
  while (SolveProcess(case_file, directory("interrupted"), {"--wall-time", "0.05"}).wait() == 75)
    ASSERT_LT(++interruptions, 300);
  EXPECT_GE(interruptions, 2);
  expect_same_answer("interrupted", "undisturbed");
}

TEST_F(SolveTest, AnErrorThatTheFinestRungDoesNotMeetIsAWarning) {
  ASSERT_EQ(solve(write_case(R"({"Ca": 0.5, "V": 10, "fluid": "quasisteady", "until": {"kt": 0.2},
    "fidelity": {"error": 0.001, "box": 6.4}, "outputs": {"shapes_every": 0}})"),
                  "climb"),
            0);
  EXPECT_EQ(result("climb")["error"]["met"], false);
  EXPECT_EQ(result("climb")["error"]["nodes"], 10242);
  EXPECT_THAT(result("climb")["trust"]["warnings"].dump(),
              HasSubstr("the error asked for, 0.001, was not met"));
}

// Without bending stiffness no error below 0.003 is stated.
TEST_F(SolveTest, AClimbEndsWhereFinerRungsComeNoNearerAndSaysSo) {
  ASSERT_EQ(solve(write_case(R"({"Ca": 0.1, "fluid": "stokes", "until": {"kt": 0.2},
    "fidelity": {"error": 0.001}, "outputs": {"shapes_every": 0}})"),
                  "climb"),
            0);
  const nlohmann::json error = result("climb")["error"];
  EXPECT_EQ(error["met"], false);
  EXPECT_LT(error["nodes"], 5762);
  EXPECT_THAT(result("climb")["trust"]["warnings"].dump(),
              AllOf(HasSubstr("the error asked for, 0.001, was not met"),
                    HasSubstr("does not fall any further with the resolution\"")));
}

// Its membrane folds on every mesh.
TEST_F(SolveTest, AClimbEndsAtAFineMeshThatFailsAndSaysWhy) {
  ASSERT_EQ(solve(write_case(R"({"shape": "oblate", "aspect": 0.68, "Ca": 0.59, "V": 0.14, "fluid": "stokes",
    "until": {"kt": 8}, "fidelity": {"error": 0.005}, "outputs": {"shapes_every": 0}})"),
                  "climb"),
            3);
  EXPECT_THAT(result("climb")["trust"]["warnings"].dump(), HasSubstr("the run with 1442 nodes failed: "));
  EXPECT_FALSE(fs::exists(directory("climb") / "rungs/2562"));
}

// As nohup does.
TEST_F(SolveTest, ClosedTerminalDoesNotStopARunThatIgnoresSighup) {
  const fs::path case_file = write_case(kQuick);
  std::signal(SIGHUP, SIG_IGN);
  SolveProcess process(case_file, directory("nohup"));
  std::signal(SIGHUP, SIG_DFL);
  process.wait_for_writes(20);
  process.send(SIGHUP);
  EXPECT_EQ(process.wait(), 0);
}

TEST_F(SolveTest, SecondProcessInADirectoryIsRefusedAndTheFirstIsNotDisturbed) {
  const fs::path case_file = write_case(kQuick);
  SolveProcess first(case_file, directory("shared"));
  first.wait_for_writes(20);
  first.send(SIGSTOP);
  EXPECT_EQ(solve(case_file, "shared"), 1);
  EXPECT_THAT(log("shared"), HasSubstr("another process computes in " + directory("shared").string()));
  first.send(SIGCONT);
  EXPECT_EQ(first.wait(), 0);
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  expect_same_answer("shared", "undisturbed");
}

TEST_F(SolveTest, DirectoryOfAKilledProcessIsFree) {
  const fs::path case_file = write_case(kQuick);
  SolveProcess first(case_file, directory("killed"));
  first.wait_for_writes(20);
  first.send(SIGKILL);
  EXPECT_EQ(first.wait(), -SIGKILL);
  EXPECT_EQ(solve(case_file, "killed"), 0);
}

TEST_F(SolveTest, InvalidCaseExitsWith2AndPrintsAllIssues) {
  const fs::path case_file = write_case(R"({"shape": "cube", "Ca": -1, "V": "thick", "colour": "red"})");
  EXPECT_EQ(solve(case_file, "invalid"), 2);
  for (const char* pointer : {"/shape: ", "/Ca: ", "/V: ", "/colour: "})
    EXPECT_THAT(log("invalid"), HasSubstr(pointer));
  EXPECT_FALSE(fs::exists(directory("invalid") / "result.json"));
}

TEST_F(SolveTest, DirectoryOfAnotherCaseIsRefused) {
  const std::string start = R"({"fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162}, "until": {"kt": 0.1}, )";
  EXPECT_EQ(solve(write_case(start + R"("Ca": 0.1})"), "taken"), 0);
  EXPECT_EQ(solve(write_case(start + R"("Ca": 0.2})"), "taken"), 2);
  EXPECT_THAT(log("taken"), HasSubstr("another case"));
}

TEST_F(SolveTest, DivergingCaseExitsWith3AndItsResultSaysWhatAndWhen) {
  const fs::path case_file = write_case(R"({"shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.05,
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.5}, "until": {"kt": 20}})");
  EXPECT_EQ(solve(case_file, "diverging"), 3);
  EXPECT_EQ(result("diverging")["stop"], "diverged");
  EXPECT_THAT(result("diverging")["message"].get<std::string>(), HasSubstr("at kt = "));
  EXPECT_FALSE(history("diverging").empty());
}

class SolveOnASmallDisk : public SolveTest {
 protected:
  SmallDisk disk_{"1m"};
};

TEST_F(SolveOnASmallDisk, FullDiskEndsTheRunWhichIsResumedOnceThereIsRoom) {
  if (!disk_.is_mounted()) GTEST_SKIP() << "this user may not mount a tmpfs";
  const fs::path case_file = write_case(kQuick);
  ASSERT_EQ(solve(case_file, "undisturbed"), 0);
  fs::create_directory_symlink(disk_.path(), directory("small"));
  {
    SolveProcess process(case_file, directory("small"));
    process.wait_for_writes(60);
    disk_.fill();
    EXPECT_EQ(process.wait(), 1);
  }
  EXPECT_THAT(log("small"), HasSubstr("capstan solve: "));
  EXPECT_FALSE(fs::exists(directory("small") / "result.json"));
  disk_.clear();
  EXPECT_EQ(solve(case_file, "small"), 0);
  EXPECT_THAT(log("small"), HasSubstr("resumed at step"));
  expect_same_answer("small", "undisturbed");
}

/// tests/reference/run_directory_1 was written by a process of format 1 and numerics version 1.
class OldRunDirectory : public SolveTest {
 protected:
  const fs::path kept_ = source_directory() / "tests/reference/run_directory_1";
};

TEST_F(OldRunDirectory, UnfinishedRunStartsAnewAndSaysWhy) {
  fs::copy(kept_, directory("old"));
  fs::remove(directory("old") / "result.json");
  ASSERT_EQ(solve(kept_ / "case.json", "old"), 0);
  EXPECT_THAT(log("old"), HasSubstr("checkpoint-a.h5 has format 1"));
  EXPECT_EQ(result("old")["stop"], "reached_end");
}

}  // namespace
}  // namespace capstan
