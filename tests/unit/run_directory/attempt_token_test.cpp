#include "solver/run_directory/attempt_token.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "solver/run_directory/durable_file.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

/// An attempt is that of a whole process: each of these tests forks one.
class AttemptToken : public ::testing::Test {
 protected:
  /// A process of the attempt with this token.
  static void become(const RunDirectory& directory, const std::string& token) {
    setenv(kTokenVariable, token.c_str(), 1);
    publish_only_as_own_attempt(directory);
  }
  /// Exits with 0 if a result can be published, with 1 if the attempt was withdrawn.
  [[noreturn]] static void publish(const RunDirectory& directory) {
    try {
      write_durably(directory.result_file(), "mine");
    } catch (const AttemptWithdrawn&) {
      std::_Exit(1);
    }
    std::_Exit(0);
  }

  TemporaryDirectory parent_;
  RunDirectory directory_{parent_.path()};
};

TEST_F(AttemptToken, ProcessOfThePresentAttemptPublishes) {
  directory_.begin_attempt("first");
  EXPECT_EXIT((become(directory_, "first"), publish(directory_)), ::testing::ExitedWithCode(0), "");
  EXPECT_EQ(file_bytes(directory_.result_file()), "mine");
}

TEST_F(AttemptToken, ProcessOfAReplacedAttemptReplacesNoFile) {
  directory_.begin_attempt("first");
  const auto be_replaced = [this] { overwrite(directory_.attempt_file(), "second\n"); };
  EXPECT_EXIT((become(directory_, "first"), be_replaced(), publish(directory_)), ::testing::ExitedWithCode(1),
              "");
  EXPECT_FALSE(std::filesystem::exists(directory_.result_file()));
}

TEST_F(AttemptToken, ProcessOfAWithdrawnAttemptReplacesNoFile) {
  directory_.begin_attempt("first");
  EXPECT_EXIT((become(directory_, "first"), directory_.withdraw_attempt(), publish(directory_)),
              ::testing::ExitedWithCode(1), "");
}

TEST_F(AttemptToken, ProcessThatStartsAfterItsAttemptWasReplacedDoesNothing) {
  directory_.begin_attempt("second");
  const auto start = [this] {
    try {
      become(directory_, "first");
    } catch (const AttemptWithdrawn&) {
      std::_Exit(1);
    }
  };
  EXPECT_EXIT(start(), ::testing::ExitedWithCode(1), "");
}

TEST_F(AttemptToken, ProcessesOfTwoAttemptsShareNoTemporaryFile) {
  const auto print_name = [this](const char* token) {
    become(directory_, token);
    std::fputs(temporary_name(directory_.result_file()).c_str(), stderr);
    std::_Exit(0);
  };
  directory_.begin_attempt("first");
  EXPECT_EXIT(print_name("first"), ::testing::ExitedWithCode(0), "result.json.first.partial");
}

TEST_F(AttemptToken, ProcessWithoutATokenPublishes) {
  directory_.begin_attempt("first");
  EXPECT_EXIT(publish(directory_), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace capstan
