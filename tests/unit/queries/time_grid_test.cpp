#include "runner/queries/time_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace capstan {
namespace {

/// Records with these times, and D_xy = kt / 10.
History records_at(std::initializer_list<double> times) {
  History records;
  for (const double kt : times) {
    Record& record = records.emplace_back();
    record["kt"] = kt;
    record["D_xy"] = kt / 10;
  }
  return records;
}

TEST(TimeGrid, TimesAreTheDecimalNumbersThatTheDistanceSays) {
  EXPECT_EQ((TimeGrid{0.1, 10}.time(3)), 0.3);
  EXPECT_EQ((TimeGrid{0.7, 10}.time(3)), 2.1);
}

TEST(TimeGrid, HistoryIsLinearBetweenTwoRecords) {
  const History history = on_grid(records_at({0, 1, 4}), {0.5, 9});
  ASSERT_EQ(history.size(), 9u);
  for (std::size_t i = 0; i < history.size(); ++i) EXPECT_NEAR(history[i]["D_xy"], 0.05 * double(i), 1e-15);
}

TEST(TimeGrid, HistoryHasNoNumbersBeforeItsFirstAndAfterItsLastRecord) {
  const History history = on_grid(records_at({1, 2}), {1, 4});
  EXPECT_TRUE(std::isnan(history[0]["D_xy"]));
  EXPECT_EQ(history[1]["D_xy"], 0.1);
  EXPECT_EQ(history[2]["D_xy"], 0.2);
  EXPECT_TRUE(std::isnan(history[3]["D_xy"]));
  EXPECT_TRUE(std::isnan(on_grid({}, {1, 1})[0]["D_xy"]));
}

TEST(TimeGrid, RecordWithARoundedTimeIsTakenAsItIs) {
  History records = records_at({0, 0.3, 1 - 1e-12});
  records[0]["D_xy"] = std::nan("");
  const History history = on_grid(records, {0.1, 11});
  EXPECT_TRUE(std::isnan(history[1]["D_xy"])) << "between a record without a number and another";
  EXPECT_EQ(history[3]["D_xy"], 0.03);
  EXPECT_EQ(history[10]["D_xy"], records[2]["D_xy"]);
}

}  // namespace
}  // namespace capstan
