#include "runner/render/boundary_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

/// One row with a crossing, one that tumbles everywhere.
ordered_json boundary() {
  return ordered_json::parse(
      R"({"along": "Ca", "for": ["V"], "between": [0.05, 1], "explored": 0.53, "searching": false,
    "points": {"asked": 20, "ended": 20, "expected": 0},
    "rows": [
      {"at": {"V": 2}, "searching": false, "first": "tumbling", "last": "tank_treading", "crossings": [
        {"from": "tumbling", "to": "tank_treading", "value": 1, "low": 0.8, "high": null, "band": [0.75, 1.25],
         "found": true, "confirmed": [0.1, null]}]},
      {"at": {"V": 8}, "searching": false, "first": "tumbling", "last": "tumbling", "crossings": []}]})");
}

TEST(BoundaryTable, HasOneRowForEachCrossing) {
  EXPECT_EQ(as_csv(boundary_table(boundary())),
            "V,from,to,Ca,low,high,band_begin,band_end,band_width,confirmed_below,confirmed_above,found\r\n"
            "2,tumbling,tank_treading,1,0.8,,0.75,1.25,0.5,0.1,,true\r\n");
}

TEST(BoundaryText, NamesTheRowsOfOneMotionAndWhatWasCovered) {
  const std::string text = boundary_text(boundary());
  EXPECT_THAT(text, HasSubstr("V = 8: tumbling from Ca = 0.05 to 1\n"));
  EXPECT_THAT(text, HasSubstr("wider than 53 % of its Ca"));
}

TEST(BoundaryText, SaysHowManyPointsAreStillExpected) {
  ordered_json searching = boundary();
  searching["searching"] = true;
  searching["points"] = {{"asked", 20}, {"ended", 15}, {"expected", 9}};
  EXPECT_THAT(boundary_text(searching), HasSubstr("15 of 20 points have ended; about 9 more will follow."));
  EXPECT_THAT(boundary_text(searching), HasSubstr("will have been looked for"));
}

TEST(BoundaryText, ClaimsNothingOfACancelledStudy) {
  ordered_json cancelled = boundary();
  cancelled["points"]["ended"] = 6;
  EXPECT_THAT(boundary_text(cancelled), HasSubstr("6 of 20 points have ended; the study is cancelled"));
  EXPECT_THAT(boundary_text(cancelled), Not(HasSubstr("looked for")));
}

TEST(BoundaryText, SaysThatRowsWithoutAMotionHideIslands) {
  ordered_json unknown = boundary();
  unknown["rows"][1]["first"] = unknown["rows"][1]["last"] = nullptr;
  EXPECT_THAT(boundary_text(unknown), HasSubstr("V = 8: no motion is known"));
  EXPECT_THAT(boundary_text(unknown), HasSubstr("raise until.at_most"));
}

}  // namespace
}  // namespace capstan
