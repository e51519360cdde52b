#include "runner/queries/disk_warning.hpp"

#include <gmock/gmock.h>

namespace capstan {
namespace {

TEST(DiskWarning, IsGivenWhereAStudyDoesNotFit) {
  EXPECT_EQ(disk_warning(1e9, 2e9, "/data/runs"), "");
  EXPECT_THAT(disk_warning(3.14e9, 2e9, "/data/runs"),
              ::testing::StartsWith("its cases will take about 3.1 GB, and 2.0 GB are free in /data/runs: "));
}

}  // namespace
}  // namespace capstan
