#include "runner/worker/solve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "solver/output/shape_writer.hpp"
#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

class SolveCase : public ::testing::Test {
 protected:
  /// A sphere by boundary integrals, some hundredths of a second.
  static std::string sphere(double Ca = 0.1, const std::string& until = R"({"kt": 0.2})") {
    return R"({"fluid": "stokes", "fidelity": {"nodes": 42}, "Ca": )" + std::to_string(Ca) +
           R"(, "until": )" + until + R"(, "outputs": {"history_every": 0.05, "shapes_every": 0.1}})";
  }

  /// The exit code; what was printed is in `printed_`.
  int solve(const std::string& text, const RunDirectory& directory, double wall_seconds = kNoLimit,
            const std::filesystem::path& shorter = {}) {
    overwrite(root_.path() / "case.json", text);
    ::testing::internal::CaptureStderr();
    const int code = solve_case(root_.path() / "case.json", directory.path(), wall_seconds, shorter);
    printed_ = ::testing::internal::GetCapturedStderr();
    return code;
  }

  nlohmann::json result(const RunDirectory& directory) {
    return nlohmann::json::parse(file_bytes(directory.result_file()));
  }

  TemporaryDirectory root_;
  const RunDirectory run_{root_.path() / "run"}, other_{root_.path() / "other"};
  std::string printed_;
};

TEST_F(SolveCase, DoneRunWritesCaseHistoryAndResult) {
  EXPECT_EQ(solve(sphere(), run_), kExitDone) << printed_;
  EXPECT_EQ(result(run_)["stop"], "reached_end");
  EXPECT_EQ(nlohmann::json::parse(file_bytes(run_.case_file()))["Ca"], 0.1);
  EXPECT_FALSE(file_bytes(run_.history_file()).empty());
}

TEST_F(SolveCase, RunAtItsWallTimeIsInterruptedAndResumedToTheSameAnswer) {
  EXPECT_EQ(solve(sphere(), run_, 0), kExitInterrupted);
  EXPECT_FALSE(std::filesystem::exists(run_.result_file()));
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  EXPECT_THAT(printed_, HasSubstr("resumed at step 1, kt = "));
  EXPECT_EQ(solve(sphere(), other_), kExitDone);
  EXPECT_EQ(file_bytes(run_.history_file()), file_bytes(other_.history_file()));
  EXPECT_EQ(result(run_)["final"], result(other_)["final"]);
}

TEST_F(SolveCase, LongerRunGoesOnFromAShorterOneAndHasTheSameFiles) {
  const std::string longer = sphere(0.1, R"({"kt": 0.35})");
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  EXPECT_EQ(solve(longer, other_), kExitDone);
  const RunDirectory prolonged(root_.path() / "prolonged");
  EXPECT_EQ(solve(longer, prolonged, kNoLimit, run_.path()), kExitDone) << printed_;
  EXPECT_THAT(printed_, HasSubstr("resumed at step"));
  EXPECT_EQ(file_bytes(prolonged.history_file()), file_bytes(other_.history_file()));
  EXPECT_EQ(file_bytes(prolonged.shape_index_file()), file_bytes(other_.shape_index_file()));
  EXPECT_TRUE(std::filesystem::exists(prolonged.frame_file(0)));
  EXPECT_EQ(result(prolonged)["final"], result(other_)["final"]);
}

TEST_F(SolveCase, LongerRunStartsAnewIfAShapeOfTheShorterOneIsDamaged) {
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  overwrite(run_.frame_file(1), "half of it");
  EXPECT_EQ(solve(sphere(0.1, R"({"kt": 0.35})"), other_, kNoLimit, run_.path()), kExitDone) << printed_;
  EXPECT_THAT(printed_, HasSubstr("0001.h5 cannot be read: the run starts anew"));
  EXPECT_FALSE(first_damaged_frame(other_, 4));
}

TEST_F(SolveCase, CompanionGoesOnFromThatOfTheShorterRun) {
  const auto with_companion = [](const char* kt) {
    return std::string(R"({"fluid": "stokes", "fidelity": {"nodes": 162}, "Ca": 0.1, "until": {"kt": )") +
           kt + R"(}, "outputs": {"shapes_every": 0}})";
  };
  EXPECT_EQ(solve(with_companion("0.2"), run_), kExitDone);
  EXPECT_EQ(solve(with_companion("0.4"), other_, kNoLimit, run_.path()), kExitDone);
  EXPECT_THAT(printed_, ::testing::ContainsRegex("companion with 42 nodes\nresumed at step"));
}

TEST_F(SolveCase, ErrorAskedForGoesOnFromAllRungsOfTheShorterRun) {
  const auto climb = [](const char* kt) {
    return std::string(R"({"fluid": "stokes", "fidelity": {"error": 0.03}, "Ca": 0.1, "until": {"kt": )") +
           kt + R"(}, "outputs": {"shapes_every": 0.1}})";
  };
  EXPECT_EQ(solve(climb("0.2"), run_), kExitDone);
  EXPECT_EQ(solve(climb("0.4"), other_, kNoLimit, run_.path()), kExitDone) << printed_;
  EXPECT_THAT(printed_, HasSubstr("resumed at step"));
  const RunDirectory direct(root_.path() / "direct");
  EXPECT_EQ(solve(climb("0.4"), direct), kExitDone);
  EXPECT_EQ(file_bytes(other_.history_file()), file_bytes(direct.history_file()));
  EXPECT_EQ(file_bytes(other_.shape_index_file()), file_bytes(direct.shape_index_file()));
  EXPECT_EQ(result(other_)["error"]["Q"], result(direct)["error"]["Q"]);
}

TEST_F(SolveCase, RunFromWhichTheCaseCannotGoOnIsRefusedWithTheReason) {
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  const std::tuple<std::string, RunDirectory, std::string> refused[] = {
      {sphere(0.1, R"({"kt": 0.1})"), run_, "ended at kt = 0.2, which this case does not pass"},
      {sphere(0.1, R"({"kt": 5, "classified": true})"), run_, "ask for the same until.classified"},
      {sphere(0.2, R"({"kt": 5})"), run_, "only until, companion and outputs.checkpoint_every may differ"},
      {sphere(0.1, R"({"kt": 5})"), RunDirectory(root_.path()), "holds no finished run"}};
  for (const auto& [text, shorter, reason] : refused) {
    EXPECT_EQ(solve(text, other_, kNoLimit, shorter.path()), kExitInvalidInput);
    EXPECT_THAT(printed_, HasSubstr(reason));
  }
}

TEST_F(SolveCase, FinishedRunIsDoneAgainWithTheSameAnswer) {
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  const nlohmann::json before = result(run_);
  EXPECT_EQ(solve(sphere(), run_), kExitDone);
  EXPECT_EQ(result(run_)["final"], before["final"]);
}

TEST_F(SolveCase, InvalidCaseIsRefusedWithEveryIssueAndLeavesNoDirectory) {
  EXPECT_EQ(solve(R"({"Ca": -1, "colour": "red"})", run_), kExitInvalidInput);
  EXPECT_THAT(printed_, ::testing::AllOf(HasSubstr("/Ca: "), HasSubstr("/colour: ")));
  EXPECT_FALSE(std::filesystem::exists(run_.path()));
}

TEST_F(SolveCase, DirectoryOfAnotherCaseIsRefused) {
  EXPECT_EQ(solve(sphere(0.1), run_), kExitDone);
  EXPECT_EQ(solve(sphere(0.2), run_), kExitInvalidInput);
  EXPECT_THAT(printed_, HasSubstr("holds the run of another case"));
}

TEST_F(SolveCase, DirectoryInWhichAnotherProcessComputesIsRefused) {
  std::filesystem::create_directories(run_.path());
  const int first_free =
      dup(STDERR_FILENO);  // so that the lock does not look like one that a daemon has left
  DirectoryLock lock(run_);
  close(first_free);
  ASSERT_TRUE(lock.take());
  EXPECT_EQ(solve(sphere(), run_), kExitError);
  EXPECT_THAT(printed_, HasSubstr("another process computes in " + run_.path().string()));
  EXPECT_FALSE(std::filesystem::exists(run_.case_file()));
}

TEST_F(SolveCase, DivergedRunHasNoAnswerAndItsResultSaysWhy) {
  EXPECT_EQ(solve(R"({"shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.05,
    "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.5}, "until": {"kt": 20}})",
                  run_),
            kExitNoAnswer);
  EXPECT_EQ(result(run_)["stop"], "diverged");
  EXPECT_THAT(result(run_)["message"].get<std::string>(), HasSubstr("at kt = "));
}

TEST_F(SolveCase, DirectoryThatCannotBeMadeIsAnErrorThatNamesIt) {
  overwrite(run_.path(), "a file in its place");
  EXPECT_EQ(solve(sphere(), run_), kExitError);
  EXPECT_THAT(printed_, HasSubstr(run_.path().string()));
}

TEST_F(SolveCase, MissingCaseFileIsAnErrorThatNamesIt) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(solve_case(root_.path() / "nowhere.json", run_.path(), kNoLimit), kExitError);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("nowhere.json"));
}

}  // namespace
}  // namespace capstan
