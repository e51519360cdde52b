#include "solver/run_directory/history_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace capstan {
namespace {

Record example() {
  Record record;
  record["kt"] = 0.1;
  record["D_xy"] = 0.0482;
  record["theta"] = 0.7711;
  record["psi"] = -0.0021;
  record["volume"] = 4.18879;
  record["area"] = 12.5663;
  record["iterations"] = 1;
  record["error"] = 0.0004;
  return record;
}

TEST(HistoryLine, ReadsBackToTheSameBits) {
  Record record = example();
  record["kt"] = 0.1 + 0.2;
  record["D_xy"] = 1.0 / 3;
  record["psi"] = 1e-300;
  EXPECT_EQ(parse_record(to_json_line(record)), record);
}

TEST(HistoryLine, IsWhatTheSchemaSays) {
  EXPECT_EQ(to_json_line(example()),
            R"({"kt":0.1,"D_xy":0.0482,"theta":0.7711,"psi":-0.0021,"volume":4.18879,"area":12.5663,)"
            R"("iterations":1,"error":0.0004})");
}

TEST(HistoryLine, CutAnywhereIsNoRecord) {
  const std::string line = to_json_line(example());
  for (size_t length = 0; length < line.size(); ++length)
    EXPECT_FALSE(parse_record(line.substr(0, length))) << length;
}

TEST(HistoryLine, NumbersThatAreNotFiniteBecomeNull) {
  Record record = example();
  record["D_xy"] = std::nan("");
  record["area"] = INFINITY;
  record["iterations"] = std::nan("");
  const std::string line = to_json_line(record);
  for (const char* part : {"\"D_xy\":null", "\"area\":null", "\"iterations\":null"})
    EXPECT_NE(line.find(part), std::string::npos) << line;
  EXPECT_TRUE(std::isnan(parse_record(line).value()["D_xy"]));
}

TEST(HistoryLine, MissingNumbersAreLeftOutOnRequest) {
  Record record;
  record["kt"] = 2;
  EXPECT_EQ(to_json_line(record, Missing::left_out), R"({"kt":2.0})");
}

TEST(HistoryLine, OtherKeysAreIgnored) {
  const Record record = parse_record(R"({"kt":1.5,"of a later version":3})").value();
  EXPECT_EQ(record["kt"], 1.5);
  EXPECT_TRUE(std::isnan(record["D_xy"]));
}

TEST(Observables, HaveNamesThatDifferAlsoWithoutCase) {
  const auto small = [](std::string_view name) {
    std::string text(name);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  };
  std::vector<std::string> names = {"case_id", "record"};  // the other columns of the table `histories`
  for (const Observable& observable : kObservables) names.push_back(small(observable.name));
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(Observables, HaveNamesThatAreColumnsInSqlWithoutQuotes) {
  for (const auto& [name, unit, description, type, is_in_database] : kObservables) {
    EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(name.front()))) << name;
    EXPECT_TRUE(std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; }))
        << name;
    EXPECT_FALSE(unit.empty() || description.empty()) << name;
  }
}

}  // namespace
}  // namespace capstan
