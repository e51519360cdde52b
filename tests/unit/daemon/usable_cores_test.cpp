#include "runner/daemon/usable_cores.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>
#include <thread>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

/// The mask is that of one thread, so that the other tests keep theirs.
TEST(UsableCores, AreThoseOfTheAffinityMask) {
  int cores = 0;
  std::thread([&] {
    cpu_set_t all, one;
    sched_getaffinity(0, sizeof all, &all);
    CPU_ZERO(&one);
    for (int cpu = 0; CPU_COUNT(&one) == 0; ++cpu)
      if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
    sched_setaffinity(0, sizeof one, &one);
    cores = usable_cores();
  }).join();
  EXPECT_EQ(cores, 1);
}

TEST(UsableCores, AreAtMostThoseOfTheJobOfSlurm) {
  setenv("SLURM_CPUS_ON_NODE", "1", 1);
  EXPECT_EQ(usable_cores(), 1);
  setenv("SLURM_CPUS_ON_NODE", "100000", 1);
  const int without_limit = usable_cores();
  unsetenv("SLURM_CPUS_ON_NODE");
  EXPECT_EQ(usable_cores(), without_limit);
}

class Quota : public ::testing::Test {
 protected:
  void limit(const std::string& group, const std::string& text) {
    std::filesystem::create_directories(root_.path() / group);
    std::ofstream(root_.path() / group / "cpu.max") << text << '\n';
  }

  TemporaryDirectory root_;
};

TEST_F(Quota, IsTheSmallestOfTheGroupAndThoseAbove) {
  limit("slice", "200000 100000");
  limit("slice/service", "max 100000");
  EXPECT_EQ(cores_by_quota(root_.path(), "/slice/service"), 2);
  limit("slice/service", "50000 100000");
  EXPECT_EQ(cores_by_quota(root_.path(), "/slice/service"), 1);
}

TEST_F(Quota, OfAPartOfACoreIsRoundedUp) {
  limit("", "150000 100000");
  EXPECT_EQ(cores_by_quota(root_.path(), "/"), 2);
}

TEST_F(Quota, IsZeroWhereThereIsNone) {
  EXPECT_EQ(cores_by_quota(root_.path(), "/slice/service"), 0);
  limit("slice", "max 100000");
  EXPECT_EQ(cores_by_quota(root_.path(), "/slice"), 0);
}

}  // namespace
}  // namespace capstan
