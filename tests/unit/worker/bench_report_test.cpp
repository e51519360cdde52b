#include "runner/worker/bench_report.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace capstan {
namespace {

const nlohmann::ordered_json kRows = {{{"dx", 0.1}, {"ms", 2}}};

TEST(BenchReport, TablesAreOneJsonDocument) {
  std::ostringstream out;
  BenchReport report(out, true);
  report.add("first", kRows);
  report.add("second", kRows);
  report.finish();
  const auto document = nlohmann::json::parse(out.str());
  EXPECT_EQ(document["tables"].size(), 2u);
  EXPECT_EQ(document["tables"][1]["title"], "second");
  EXPECT_EQ(document["tables"][1]["rows"][0]["ms"], 2);
}

TEST(BenchReport, TableIsPrintedAsTextAsSoonAsItIsAdded) {
  std::ostringstream out;
  BenchReport report(out, false);
  report.add("first", kRows);
  EXPECT_EQ(out.str(), "\nfirst\n\n dx  ms\n0.1   2\n");
}

}  // namespace
}  // namespace capstan
