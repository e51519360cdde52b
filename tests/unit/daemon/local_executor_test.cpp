#include "runner/daemon/local_executor.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <system_error>

#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/parent_daemon.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The worker is a shell script.
class LocalExecutorTest : public ::testing::Test {
 protected:
  void SetUp() override { directory_.prepare("{}"); }

  RunHandle start(const std::string& script) {
    overwrite(program_, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program_, std::filesystem::perms::owner_all);
    return executor_.start(claim_, directory_);
  }
  /// Waits for the end of the process; does not reap it.
  static void wait_for(const RunHandle& run) {
    EXPECT_TRUE(wait_for_end(process_from_text(run).value(), 60'000));
  }
  ProcessEnd end_of(const std::string& script) {
    const RunHandle run = start(script);
    wait_for(run);
    return executor_.poll(run).value();
  }
  std::string log() const { return file_bytes(directory_.log_file()); }

  TemporaryDirectory parent_;
  RunDirectory directory_{parent_.path() / "run"};
  std::filesystem::path program_ = parent_.path() / "program";
  Claim claim_{.case_id = "1", .document = "{}", .token = "token", .attempt = 1, .handle = ""};
  LocalExecutor executor_{1, program_};
};

TEST_F(LocalExecutorTest, StartsSolveWithCaseAndDirectory) {
  end_of("echo \"$@\"");
  EXPECT_EQ(log(),
            "solve " + directory_.case_file().string() + " --out " + directory_.path().string() + "\n");
}

TEST_F(LocalExecutorTest, WritesBothOutputsToTheLogAndKeepsWhatItHeld) {
  overwrite(directory_.log_file(), "earlier\n");
  end_of("echo output; echo error >&2");
  EXPECT_EQ(log(), "earlier\noutput\nerror\n");
}

TEST_F(LocalExecutorTest, ReportsTheExitCode) {
  const ProcessEnd end = end_of("exit 75");
  EXPECT_EQ(end.how, ProcessEnd::How::exited);
  EXPECT_EQ(end.number, 75);
}

TEST_F(LocalExecutorTest, ReportsTheSignalThatKilledTheRun) {
  const ProcessEnd end = end_of("kill -KILL $$");
  EXPECT_EQ(end.how, ProcessEnd::How::signalled);
  EXPECT_EQ(end.number, SIGKILL);
}

TEST_F(LocalExecutorTest, ProgramThatCannotBeStartedIsAnError) {
  EXPECT_THROW(executor_.start(claim_, directory_), std::system_error);
  EXPECT_TRUE(executor_.wait_until_free(directory_));
}

TEST_F(LocalExecutorTest, GivesTheWorkerOneThreadAndTheDaemonsProcessId) {
  setenv("OMP_NUM_THREADS", "7", 1);
  end_of("echo $OMP_NUM_THREADS $" + std::string(kDaemonVariable));
  unsetenv("OMP_NUM_THREADS");
  EXPECT_EQ(log(), "1 " + std::to_string(getpid()) + "\n");
}

TEST_F(LocalExecutorTest, KeepsTheTokenFromTheWorker) {
  setenv("CAPSTAN_TOKEN", "secret", 1);
  setenv("CAPSTAN_TOKEN_FILE", "/secret", 1);
  end_of("env");
  unsetenv("CAPSTAN_TOKEN");
  unsetenv("CAPSTAN_TOKEN_FILE");
  EXPECT_THAT(log(), Not(HasSubstr("secret")));
}

/// A client's connection that a worker inherited would stay open after the daemon has closed it.
TEST_F(LocalExecutorTest, PassesNoDescriptorOnButTheLock) {
  constexpr int kConnection = 42;
  ASSERT_EQ(dup2(STDERR_FILENO, kConnection), kConnection);  // without close-on-exec
  end_of("for fd in 3 42; do [ -e /proc/self/fd/$fd ] && echo $fd; done");
  close(kConnection);
  EXPECT_EQ(log(), std::to_string(DirectoryLock::kInheritedDescriptor) + "\n");
}

TEST_F(LocalExecutorTest, RunHoldsTheLockOfItsDirectoryUntilItEnds) {
  const RunHandle run = start("exec sleep 600");
  EXPECT_FALSE(DirectoryLock(directory_).take());
  EXPECT_THROW(executor_.start(claim_, directory_), std::system_error) << "a second run in the directory";
  executor_.cancel(run, StopBy::kill);
  EXPECT_TRUE(executor_.wait_until_free(directory_));
  EXPECT_TRUE(DirectoryLock(directory_).take());
}

TEST_F(LocalExecutorTest, HasNoEndWhileTheRunGoesOn) {
  const RunHandle run = start("exec sleep 600");
  EXPECT_FALSE(executor_.poll(run));
  EXPECT_TRUE(executor_.usage(run));
  executor_.cancel(run, StopBy::kill);
  EXPECT_EQ(executor_.poll(run).value().number, SIGKILL);
  EXPECT_FALSE(executor_.usage(run));
}

/// SIGTERM is blocked until the worker has its handlers; a shell never unblocks it.
TEST_F(LocalExecutorTest, StopThatComesBeforeTheHandlersWaitsForThem) {
  const RunHandle run = start("exec sleep 600");
  executor_.cancel(run, StopBy::checkpoint);
  const pid_t pid = process_from_text(run)->pid;
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string pending;
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("ShdPnd:")) pending = line.substr(line.find_last_of('\t') + 1);
  EXPECT_TRUE(std::stoull(pending, nullptr, 16) >> (SIGTERM - 1) & 1) << pending;
  EXPECT_FALSE(executor_.poll(run));
  executor_.cancel(run, StopBy::kill);
}

TEST_F(LocalExecutorTest, SuccessorFindsAndEndsTheRunOfAnEarlierDaemon) {
  const RunHandle run = start("exec sleep 600");
  LocalExecutor successor(1, program_);
  EXPECT_FALSE(successor.poll(run));
  successor.cancel(run, StopBy::kill);
  const auto end = successor.poll(run);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->how, ProcessEnd::How::lost);
  EXPECT_TRUE(successor.wait_until_free(directory_));
}

TEST_F(LocalExecutorTest, UnknownHandleIsALostRun) {
  EXPECT_EQ(executor_.poll("").value().how, ProcessEnd::How::lost);
  executor_.cancel("", StopBy::kill);
  EXPECT_FALSE(executor_.usage(""));
}

}  // namespace
}  // namespace capstan
