#include "solver/output/share_of_time.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

TEST(ShareOfTime, WorkIsDueAfterTheIntervalAndFiftyTimesItsLastDuration) {
  ShareOfTime work;
  EXPECT_FALSE(work.is_due(0.1, 0.2));
  EXPECT_TRUE(work.is_due(0.2, 0.2));
  work.done(0.2, 0.3);
  EXPECT_FALSE(work.is_due(5.2, 0.2));
  EXPECT_TRUE(work.is_due(5.31, 0.2));
  EXPECT_FALSE(work.is_due(29, 30));
}

TEST(ShareOfTime, WorkDoneWheneverItIsDueTakesAtMostTwoPercent) {
  ShareOfTime work;
  double now = 0, spent = 0;
  for (int step = 0; step < 10000; ++step, now += 0.01) {
    if (!work.is_due(now, 0.2)) continue;
    const double cost = 0.001 * (1 + step % 7);
    work.done(now, now + cost);
    now += cost, spent += cost;
  }
  EXPECT_GT(spent, 0.005 * now);
  EXPECT_LT(spent, 0.03 * now);
}

}  // namespace
}  // namespace capstan
