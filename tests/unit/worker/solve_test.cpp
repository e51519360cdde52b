#include "runner/worker/solve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>
#include <nlohmann/json.hpp>

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
  static std::string sphere(double Ca = 0.1) {
    return R"({"fluid": "stokes", "fidelity": {"nodes": 42}, "until": {"kt": 0.2}, "Ca": )" +
           std::to_string(Ca) + R"(, "outputs": {"history_every": 0.05, "shapes_every": 0}})";
  }

  /// The exit code; what was printed is in `printed_`.
  int solve(const std::string& text, const RunDirectory& directory, double wall_seconds = kNoLimit) {
    overwrite(root_.path() / "case.json", text);
    ::testing::internal::CaptureStderr();
    const int code = solve_case(root_.path() / "case.json", directory.path(), wall_seconds);
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
  EXPECT_THAT(printed_, HasSubstr("resumed at step 1\n"));
  EXPECT_EQ(solve(sphere(), other_), kExitDone);
  EXPECT_EQ(file_bytes(run_.history_file()), file_bytes(other_.history_file()));
  EXPECT_EQ(result(run_)["final"], result(other_)["final"]);
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
