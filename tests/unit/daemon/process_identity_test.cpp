#include "runner/daemon/process_identity.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

namespace capstan {
namespace {

/// A process that waits until it is killed. It is reaped at the end.
class Child {
 public:
  Child() : pid_(fork()) {
    if (pid_ == 0) {
      for (;;) pause();
    }
  }
  ~Child() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

TEST(ProcessIdentity, OfALivingProcessStaysTheSame) {
  const Child child;
  const auto identity = identify(child.pid());
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->pid, child.pid());
  EXPECT_EQ(identify(child.pid()), identity);
  EXPECT_TRUE(is_alive(*identity));
}

TEST(ProcessIdentity, DiffersForTwoProcesses) {
  const Child first, second;
  EXPECT_NE(identify(first.pid()), identify(second.pid()));
}

TEST(ProcessIdentity, IsNotThatOfALaterProcessWithTheSamePid) {
  const Child child;
  ProcessIdentity earlier = identify(child.pid()).value();
  earlier.start_time = "1";
  EXPECT_FALSE(is_alive(earlier));
  EXPECT_FALSE(usage_of(earlier));
}

TEST(ProcessIdentity, IsNotThatOfAProcessBeforeTheMachineWasRestarted) {
  const Child child;
  ProcessIdentity earlier = identify(child.pid()).value();
  earlier.boot_id = "00000000-0000-0000-0000-000000000000";
  EXPECT_FALSE(is_alive(earlier));
}

TEST(ProcessIdentity, OfAnEndedProcessThatIsNotReapedIsNone) {
  const Child child;
  const ProcessIdentity identity = identify(child.pid()).value();
  kill(child.pid(), SIGKILL);
  EXPECT_TRUE(wait_for_end(identity, 10'000));
  EXPECT_FALSE(identify(child.pid()));
  EXPECT_FALSE(is_alive(identity));
  EXPECT_FALSE(usage_of(identity));
}

TEST(ProcessIdentity, IsReadBackFromItsText) {
  const ProcessIdentity identity = identify(getpid()).value();
  EXPECT_EQ(process_from_text(to_text(identity)), identity);
}

/// Process 1 and process groups (0, negative numbers) must never be signalled.
TEST(ProcessIdentity, IsNotReadFromOtherTexts) {
  for (const char* text :
       {"", "123", "123:456", ":456:boot", "word:456:boot", "1:456:boot", "0:456:boot", "-7:456:boot"})
    EXPECT_FALSE(process_from_text(text)) << text;
}

TEST(ProcessIdentity, WaitingForALivingProcessEndsInTime) {
  const Child child;
  EXPECT_FALSE(wait_for_end(identify(child.pid()).value(), 1));
}

TEST(ProcessUsage, CountsProcessorTimeAndResidentMemory) {
  const ProcessIdentity self = identify(getpid()).value();
  const auto before = usage_of(self);
  ASSERT_TRUE(before);
  const std::clock_t begin = std::clock();
  while (std::clock() - begin < CLOCKS_PER_SEC / 10) {
  }
  EXPECT_GT(usage_of(self)->cpu_seconds, before->cpu_seconds);
  EXPECT_GT(before->resident_mb, 1);
}

}  // namespace
}  // namespace capstan
