#include "runner/results/table.hpp"

#include <gtest/gtest.h>

#include "runner/results/export.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

TEST(Table, TextAlignsNumbersRightAndWordsLeft) {
  const Table table{{"Ca", "motion"}, {{0.25, "tumbling"}, {1.0, nullptr}, {0.123456, "transition"}}};
  EXPECT_EQ(as_text(table),
            "    Ca  motion\n"
            "  0.25  tumbling\n"
            "     1\n"
            "0.1235  transition\n");
}

TEST(Table, TextShowsTheFirstLineOfAMessage) {
  EXPECT_EQ(as_text({{"message"}, {{"killed\nlast words"}}}), "message\nkilled\n");
}

TEST(Table, CsvKeepsEveryDigitAndQuotesWhatNeedsIt) {
  const Table table{{"Ca", "message"}, {{0.1234567890123, "a \"word\", and\na line"}}};
  EXPECT_EQ(as_csv(table), "Ca,message\r\n0.1234567890123,\"a \"\"word\"\", and\na line\"\r\n");
}

TEST(Table, HistoryHasAColumnAQuantity) {
  const Table table = history_table({{"kt", {0.1, 0.2}}, {"theta", {1.5, nullptr}}});
  EXPECT_EQ(as_csv(table), "kt,theta\r\n0.1,1.5\r\n0.2,\r\n");
}

TEST(Table, FullTableHasTheUnionOfWhatTheCasesHave) {
  const ordered_json shown = {{"id", "a"},
                              {"state", "done"},
                              {"motion", "tumbling"},
                              {"message", ""},
                              {"attempt", 1},
                              {"parameters", {{"Ca", 0.5}, {"until", {{"kt", 1}}}}},
                              {"final", {{"theta", 2.5}}}};
  ordered_json other = shown;
  other["parameters"] = {{"Ca", 0.6}, {"C", 5}};
  other["final"] = nullptr;
  EXPECT_EQ(as_csv(full_table({shown, other})),
            "id,state,motion,message,attempt,Ca,C,final.theta\r\n"
            "a,done,tumbling,,1,0.5,,2.5\r\n"
            "a,done,tumbling,,1,0.6,5,\r\n");
}

}  // namespace
}  // namespace capstan
