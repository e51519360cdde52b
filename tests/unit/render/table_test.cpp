#include "runner/render/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "runner/render/result_columns.hpp"
#include "runner/render/result_tables.hpp"
#include "solver/case/parse.hpp"

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

TEST(Table, TextShowsExactColumnsInFull) {
  const Table table{{"V", "D"}, {{1.000001, 0.123456}, {1.000002, 0.123457}}, {0}};
  EXPECT_EQ(as_text(table),
            "       V       D\n"
            "1.000001  0.1235\n"
            "1.000002  0.1235\n");
}

TEST(Table, TextAlignsByCharactersAndNotByBytes) {
  EXPECT_EQ(as_text({{"θ/π", "motion"}, {{0.5, "é"}, {0.25, "tumbling"}}}),
            " θ/π  motion\n"
            " 0.5  é\n"
            "0.25  tumbling\n");
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

/// A point as the server answers with it.
ordered_json point(int number, const char* asked, const ordered_json& more = ordered_json::object()) {
  const nlohmann::json wish = nlohmann::json::parse(asked);
  const ParsedCase parsed = parse_case(wish);
  ordered_json shown = {{"point", number},
                        {"id", "case " + std::to_string(number)},
                        {"state", "done"},
                        {"message", ""},
                        {"motion", "tumbling"},
                        {"kt", 30},
                        {"parameters", to_json(*parsed.value)},
                        {"asked", wish},
                        {"choices", to_json(parsed.choices)}};
  shown.update(more);
  return shown;
}

ordered_json study_over(std::initializer_list<const char*> axes) {
  ordered_json study = {{"axes", ordered_json::array()}};
  for (const char* axis : axes) study["axes"].push_back({{"parameter", axis}});
  return study;
}

ordered_json cell(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  return found == table.columns.end()
             ? ordered_json("no such column")
             : table.rows[row][static_cast<std::size_t>(found - table.columns.begin())];
}

TEST(FullTable, HasRequestedAndResolvedParametersAndResults) {
  const Table table = full_table({point(1, R"({"Ca": 0.1, "fidelity": "fast", "fluid": "quasisteady"})",
                                        {{"stop", "reached_end"},
                                         {"trust",
                                          {{"volume_drift", 0.02},
                                           {"surface", {{"largest_dihedral", 12.5}, {"lost_from", nullptr}}},
                                           {"numerics_version", 6},
                                           {"warnings", {"first", "second, \"quoted\""}}}},
                                         {"cost", {{"seconds", 1.5}}}}),
                                  point(2, R"({"Ca": 0.2})")});
  for (const auto& [column, value] : std::initializer_list<std::pair<const char*, ordered_json>>{
           {"asked.fidelity", "fast"},
           {"fidelity.nodes", 642},
           {"fidelity.dx", 0.2},
           {"fidelity.box", 25.6},
           {"until.kt", 30.0},
           {"until.classified", false},
           {"stop", "reached_end"},
           {"trust.volume_drift", 0.02},
           {"trust.surface.largest_dihedral", 12.5},
           {"trust.numerics_version", 6},
           {"trust.warnings", "first; second, \"quoted\""},
           {"cost.seconds", 1.5}})
    EXPECT_EQ(cell(table, 0, column), value) << column;
  EXPECT_TRUE(cell(table, 0, "fidelity.kdt").is_number() || cell(table, 0, "fidelity.stepper") == "rkc2");
  EXPECT_TRUE(cell(table, 1, "fidelity.dx").is_null());
  EXPECT_EQ(cell(table, 1, "choices").get<std::string>().substr(0, 27), "fluid: auto became stokes: ");
}

TEST(FullTable, HasTheSameColumnsInTheSameOrderForEveryStudy) {
  const Table one = full_table(ordered_json::array({point(1, R"({"Ca": 0.1})")}));
  const Table other = full_table({point(1, R"({"Ca": 0.1, "law": "skalak", "C": 1, "fluid": "transient"})"),
                                  point(2, R"({"Ca": 0.1})", {{"surface", {{"largest_dihedral", 0.2}}}})});
  ASSERT_EQ(other.columns.size(), one.columns.size() + 1);
  EXPECT_TRUE(std::equal(one.columns.begin(), one.columns.end(), other.columns.begin()));
  EXPECT_EQ(other.columns.back(), "surface.largest_dihedral");
  EXPECT_TRUE(full_table(ordered_json::array()).columns == one.columns);
}

TEST(FullTable, KnowsEveryKeyOfACase) {
  for (const char* wish :
       {R"({"Ca": 0.1})",
        R"({"Ca": 0.1, "shape": "oblate", "aspect": 0.5, "law": "skalak", "C": 1, "E_b": 0.1})",
        R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": {"stepper": "ab2"}})",
        R"({"Ca": 0.1, "fluid": "transient"})"}) {
    const Table table = full_table(ordered_json::array({point(1, wish)}));
    EXPECT_EQ(table.columns, known_columns()) << wish;
  }
}

TEST(SummaryTable, ShowsTheRequestedAxesAndOtherColumnsThatVary) {
  const ordered_json cases = {point(1, R"({"Ca": 0.1, "fluid": "auto", "fidelity": "fast"})"),
                              point(2, R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": "standard"})",
                                    {{"trust", {{"warnings", {"the volume drifted"}}}}, {"same_as", 1}})};
  const Table table = summary_table(study_over({"fluid", "fidelity"}), cases);
  EXPECT_EQ(cell(table, 0, "fluid"), "auto");
  EXPECT_EQ(cell(table, 0, "resolved fluid"), "stokes");
  EXPECT_EQ(cell(table, 1, "fidelity"), "standard");
  EXPECT_EQ(cell(table, 0, "nodes"), 642);
  EXPECT_EQ(cell(table, 1, "nodes"), 2562);
  EXPECT_EQ(cell(table, 1, "dx"), 0.1);
  EXPECT_EQ(cell(table, 1, "warnings"), "the volume drifted");
  EXPECT_EQ(cell(table, 1, "same as"), 1);
  EXPECT_EQ(cell(table, 1, "Ca"), "no such column") << "it does not vary";
  const Table plain_table =
      summary_table(study_over({"Ca"}), {point(1, R"({"Ca": 0.1})"), point(2, R"({"Ca": 0.2})")});
  EXPECT_EQ(plain_table.columns,
            (std::vector<std::string>{"point", "case", "Ca", "state", "motion", "kt", "D_xy", "θ/π", "margin",
                                      "error", "confirmed", "message"}));
}

TEST(SummaryTable, ShowsValuesOfAnAxisWithAllTheirDigits) {
  const Table table = summary_table(study_over({"V"}), {point(1, R"({"Ca": 0.1, "V": 1.000001})"),
                                                        point(2, R"({"Ca": 0.1, "V": 1.000002})")});
  EXPECT_THAT(as_text(table),
              ::testing::AllOf(::testing::HasSubstr("1.000001"), ::testing::HasSubstr("1.000002")));
}

TEST(SummaryTable, HasNoColumnForValuesThatOnlyUnfinishedRunsLack) {
  const ordered_json ended = {{"stop", "reached_end"}, {"trust", {{"numerics_version", 6}}}};
  const ordered_json failed = {{"stop", "diverged"}};
  const Table running =
      summary_table(study_over({"Ca"}), {point(1, R"({"Ca": 0.1})", ended), point(2, R"({"Ca": 0.2})")});
  EXPECT_EQ(cell(running, 0, "stop"), "no such column");
  EXPECT_EQ(cell(running, 0, "numerics_version"), "no such column");
  const Table all = summary_table(study_over({"Ca"}),
                                  {point(1, R"({"Ca": 0.1})", ended), point(2, R"({"Ca": 0.2})", failed)});
  EXPECT_EQ(cell(all, 1, "stop"), "diverged");
}

TEST(Table, SummaryShowsAnglesInUnitsOfPi) {
  const auto final = ordered_json::parse(R"({"final": {"theta": 1.5707963267948966}})");
  const auto cases = ordered_json::array({point(1, R"({"Ca": 0.1})", final)});
  const Table table = summary_table(study_over({"Ca"}), cases);
  EXPECT_EQ(cell(table, 0, "θ/π"), 0.5);
}

}  // namespace
}  // namespace capstan
