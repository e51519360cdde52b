// Health, readiness, metrics and documents.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

class HealthRoutesTest : public RouteFixture {};

TEST_F(HealthRoutesTest, HealthNamesTheProgram) { EXPECT_EQ(json(get("/healthz"))["program"], "capstan"); }

/// The first page of the table of histories is damaged; everything else can be read.
TEST_F(HealthRoutesTest, DamagedDatabaseIsNotReadyAndRefusesStudiesOnceTheDamageIsSeen) {
  const std::string id = submit_and_complete_one();
  const std::string found = json(get("/v1/studies/" + id + "/cases"))["cases"][0]["id"];
  service_.reset();
  const std::int64_t page = [&] {
    Database database(data_.database(), Database::Access::write);
    Statement row = database.query("SELECT rootpage FROM sqlite_schema WHERE name = 'histories'");
    return row.step() ? row.integer(0) : 0;
  }();
  ASSERT_GT(page, 1);
  constexpr std::int64_t kPage = 4096;
  std::fstream(data_.database(), std::ios::binary | std::ios::in | std::ios::out).seekp((page - 1) * kPage)
      << std::string(kPage, 'x');
  restart();
  EXPECT_EQ(get("/readyz").status, 200);
  const Response history = get("/v1/cases/" + found + "/history");
  EXPECT_EQ(history.status, 503);
  EXPECT_THAT(history.body, HasSubstr("capstan doctor"));
  EXPECT_EQ(get("/readyz").status, 503);
  EXPECT_EQ(ask("POST", "/v1/studies", study_document("api", {{"Ca", {0.5}}}).dump()).status, 503);
}

TEST_F(HealthRoutesTest, ServerIsReadyOnlyWhileItsDatabaseCanBeRead) {
  EXPECT_EQ(get("/readyz").status, 200);
  std::filesystem::rename(data_.database(), data_.path() / "gone");
  const Response response = get("/readyz");
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(response.content_type, "application/problem+json");
}

TEST_F(HealthRoutesTest, MetricsCountCasesByState) {
  submit_and_complete_one();
  EXPECT_THAT(get("/metrics").body, HasSubstr("capstan_cases{state=\"done\"} 1\n"));
  EXPECT_THAT(get("/metrics").body, HasSubstr("capstan_attempts_total{ending=\"done\"} 1\n"));
}

TEST_F(HealthRoutesTest, EverySampleOfTheMetricsHasHelpAndType) {
  submit_and_complete_one();
  std::istringstream text(get("/metrics").body);
  std::map<std::string, std::string> kinds;
  std::set<std::string> samples;
  const std::regex help("# HELP ([a-z_]+) .+"), type("# TYPE ([a-z_]+) (counter|gauge)"),
      sample("(([a-z_]+)(\\{[a-z]+=\"[^\"]*\"\\})?) [0-9.e+-]+");
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, help)) continue;
    if (std::regex_match(line, match, type)) {
      EXPECT_TRUE(kinds.emplace(match[1], match[2]).second) << line;
      continue;
    }
    ASSERT_TRUE(std::regex_match(line, match, sample)) << line;
    EXPECT_TRUE(samples.insert(match[1]).second) << line;
    ASSERT_TRUE(kinds.contains(match[2])) << line;
    EXPECT_EQ(kinds.at(match[2]) == "counter", match[2].str().ends_with("_total")) << line;
  }
  EXPECT_GT(samples.size(), 5u);
}

TEST_F(HealthRoutesTest, CountersOfMetricsNeverDecrease) {
  const auto ended = [&] {
    const std::string body = get("/metrics").body;
    int sum = 0;
    const std::regex sample("capstan_attempts_total\\{ending=\"[a-z]+\"\\} ([0-9]+)");
    for (std::sregex_iterator line(body.begin(), body.end(), sample), none; line != none; ++line)
      sum += std::stoi((*line)[1]);
    return sum;
  };
  submit_and_complete_one();
  EXPECT_EQ(ended(), 1);
  complete("run 2", "tumbling");
  service_->tick();
  EXPECT_EQ(ended(), 2);
}

TEST_F(HealthRoutesTest, RoutesAreExactlyThoseOfOpenApi) {
  std::istringstream document(get("/openapi.yaml").body);
  std::set<std::string> described, served;
  std::string path;
  for (std::string line; std::getline(document, line);) {
    if (line.starts_with("  /")) path = line.substr(2, line.size() - 3);
    if (line.starts_with("components:")) path = "";
    for (const char* method : {"GET", "POST", "PUT", "DELETE", "PATCH"}) {
      std::string key = "    " + std::string(method) + ":";
      std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
      if (!path.empty() && line.starts_with(key)) described.insert(method + (" " + path));
    }
  }
  for (const Route& route : routes())
    served.insert(std::string(route.method) + " " + std::string(route.path));
  EXPECT_EQ(described, served);
}

TEST_F(HealthRoutesTest, SchemasThatOpenApiRefersToAreServed) {
  const std::string document = get("/openapi.yaml").body;
  EXPECT_THAT(document, HasSubstr("$ref: study.schema.json"));
  const ordered_json study = json(get("/study.schema.json"));
  EXPECT_EQ(study["$id"], "study.schema.json");
  EXPECT_THAT(study["properties"]["base"].dump(), HasSubstr("case.schema.json#/properties/Ca"));
  EXPECT_TRUE(json(get("/case.schema.json"))["properties"].contains("Ca"));
}

}  // namespace
}  // namespace capstan
