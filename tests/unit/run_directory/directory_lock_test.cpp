#include "solver/run_directory/directory_lock.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <system_error>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

class DirectoryLockTest : public ::testing::Test {
 protected:
  bool is_free() const { return DirectoryLock(directory_).take(); }

  TemporaryDirectory parent_;
  RunDirectory directory_{parent_.path()};
};

TEST_F(DirectoryLockTest, IsHeldByOneAtATime) {
  DirectoryLock first(directory_);
  EXPECT_TRUE(first.take());
  EXPECT_FALSE(is_free());
}

TEST_F(DirectoryLockTest, OpenedButNotTakenLocksNobodyOut) {
  const DirectoryLock opened(directory_);
  EXPECT_TRUE(is_free());
}

TEST_F(DirectoryLockTest, IsReleasedAtItsEnd) {
  { EXPECT_TRUE(DirectoryLock(directory_).take()); }
  EXPECT_TRUE(is_free());
}

TEST_F(DirectoryLockTest, NamesTheFileThatCannotBeOpened) {
  try {
    const DirectoryLock lock{RunDirectory(parent_.path() / "absent")};
    FAIL() << "nothing was thrown";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("absent/lock"), std::string::npos);
  }
}

/// As the daemon passes the lock on: the child holds the lock after the parent has closed its own descriptor.
TEST_F(DirectoryLockTest, PassedOnToAChildIsHeldUntilTheChildIsKilled) {
  pid_t child = 0;
  {
    DirectoryLock lock(directory_);
    ASSERT_TRUE(lock.take());
    child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
  }
  EXPECT_FALSE(is_free());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(is_free());
}

/// In a child, so that this process keeps its descriptors. Exit code 0: the inherited lock was used, as a new
/// one could not be taken.
TEST_F(DirectoryLockTest, InheritedIsUsedWhereItBelongsToTheDirectory) {
  DirectoryLock lock(directory_);
  ASSERT_TRUE(lock.take());
  const pid_t child = fork();
  if (child == 0) {
    dup2(lock.descriptor(), DirectoryLock::kInheritedDescriptor);
    _exit(DirectoryLock::inherited_or_new(directory_).take() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST_F(DirectoryLockTest, InheritedOfAnotherDirectoryIsNotUsed) {
  const TemporaryDirectory other;
  DirectoryLock lock(directory_), of_other{RunDirectory(other.path())};
  ASSERT_TRUE(lock.take() && of_other.take());
  const pid_t child = fork();
  if (child == 0) {
    dup2(of_other.descriptor(), DirectoryLock::kInheritedDescriptor);
    _exit(DirectoryLock::inherited_or_new(directory_).take() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
}

}  // namespace
}  // namespace capstan
