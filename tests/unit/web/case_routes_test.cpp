// What the routes of cases answer, and the list of a study's cases.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

class CaseRoutesTest : public RouteFixture {};

TEST_F(CaseRoutesTest, CaseHasItsMotionAndTheEvidence) {
  const ordered_json found = json(get("/v1/studies/" + submit_and_complete_one() + "/cases"))["cases"];
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0]["motion"], "tumbling");
  EXPECT_EQ(found[0]["evidence"]["turns"], 2);
  EXPECT_EQ(found[0]["parameters"]["Ca"], 0.25);
  EXPECT_TRUE(found[1]["motion"].is_null());
  EXPECT_EQ(json(get("/v1/cases/" + found[0]["id"].get<std::string>()))["attempts"][0]["ending"], "done");
}

TEST_F(CaseRoutesTest, CasesAreFilteredByMotionStateAndParameters) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/cases";
  const auto count = [&](httplib::Params query) { return json(get(path, std::move(query)))["cases"].size(); };
  EXPECT_EQ(count({{"motion", "tumbling"}}), 1u);
  EXPECT_EQ(count({{"motion", "tank_treading"}}), 0u);
  EXPECT_EQ(count({{"state", "running"}, {"Ca", "0.75"}}), 1u);
  EXPECT_EQ(count({{"Ca", "0.2500"}, {"V", "4"}}), 1u);
  EXPECT_EQ(count({{"Ca", "0.25"}, {"V", "5"}}), 0u);
  EXPECT_EQ(count({{"shape", "biconcave"}}), 2u);
  EXPECT_EQ(count({{"shape", "sphere"}}), 0u);
}

TEST_F(CaseRoutesTest, FilterDistinguishesCloseValuesOfAnAxis) {
  const std::string id = json(
      ask("POST", "/v1/studies",
          study_document("close", {{"Ca", {0.1}}, {"V", {{"from", 1}, {"to", 1.00000000001}, {"count", 11}}}})
              .dump()))["id"];
  const ordered_json points = json(get("/v1/studies/" + id + "/cases", {{"V", "1.000000000003"}}))["cases"];
  ASSERT_THAT(points, SizeIs(1));
  EXPECT_EQ(points[0]["point"], 4);
}

TEST_F(CaseRoutesTest, PointsAreListedFilteredAndDrawnByTheRequestedValues) {
  const Response response = ask("POST", "/v1/studies", R"({"name": "asked", "base": {"Ca": 0.1},
      "axes": {"fluid": ["stokes", "auto", "quasisteady"], "fidelity": ["fast", {"preset": "fast", "nodes": 162}]}})");
  ASSERT_EQ(response.status, 201) << response.body;
  const ordered_json study = json(response);
  EXPECT_EQ(study["points"], 6);
  EXPECT_EQ(study["cases"]["total"], 4);
  EXPECT_THAT(study["notes"].dump(), HasSubstr("6 points are 4 cases"));
  const std::string path = "/v1/studies/" + study["id"].get<std::string>();
  const auto points = [&](httplib::Params query) {
    return json(get(path + "/cases", std::move(query)))["cases"];
  };
  const ordered_json automatic = points({{"fluid", "auto"}});
  ASSERT_THAT(automatic, SizeIs(2));
  EXPECT_EQ(automatic[0]["point"], 3);
  EXPECT_EQ(automatic[0].value("same_as", 0), 1);
  EXPECT_EQ(automatic[0]["asked"]["fluid"], "auto");
  EXPECT_EQ(automatic[0]["asked"]["fidelity"], "fast");
  EXPECT_EQ(automatic[0]["parameters"]["fluid"], "stokes");
  EXPECT_THAT(points({{"fluid", "stokes"}}), SizeIs(2))
      << "the requested value, not the one that auto resolved to";
  EXPECT_THAT(points({{"fidelity", "fast"}}), SizeIs(3));
  EXPECT_THAT(points({{"fidelity", R"({"nodes": 162, "preset": "fast"})"}, {"fluid", "auto"}}), SizeIs(1));
  EXPECT_THAT(points({{"shape", "sphere"}}), SizeIs(6)) << "a default";
  const ordered_json diagram = json(get(path + "/phase-diagram"));
  EXPECT_EQ(diagram["x"]["values"], ordered_json({"stokes", "auto", "quasisteady"}));
  for (const ordered_json& row : diagram["rows"])
    for (const ordered_json& cell : row) EXPECT_EQ(cell["state"], "queued");
}

TEST_F(CaseRoutesTest, PointNamesItsKeysWithoutEffect) {
  const std::string id = json(ask("POST", "/v1/studies", R"({"name": "asked", "base": {"Ca": 0.1},
      "axes": {"fluid": ["stokes", "quasisteady"], "Re": [0.02, 0.05]}})"))["id"];
  const ordered_json points = json(get("/v1/studies/" + id + "/cases"))["cases"];
  ASSERT_THAT(points, SizeIs(4));
  EXPECT_EQ(points[0]["without_effect"], ordered_json({"Re"}));
  EXPECT_FALSE(points[1].contains("without_effect"));
  EXPECT_FALSE(points[1].contains("same_as"));
  EXPECT_EQ(points[2].value("same_as", 0), 1);
}

TEST_F(CaseRoutesTest, HistoryIsReturnedInColumnsOrAsCsv) {
  const std::string id = submit_and_complete_one();
  const std::string case_id = json(get("/v1/studies/" + id + "/cases"))["cases"][0]["id"];
  const std::string path = "/v1/cases/" + case_id + "/history";
  EXPECT_EQ(json(get(path))["kt"], ordered_json({15.0, 30.0}));
  EXPECT_EQ(json(get(path))["theta"], ordered_json({0.5, -2.5}));
  EXPECT_TRUE(json(get(path))["psi"][0].is_null());
  EXPECT_THAT(get(path, {{"format", "csv"}}).body, StartsWith("kt,D_xy,theta,psi,volume,area\r\n15,,0.5,"));
  EXPECT_THAT(get(path, {}, "text/csv").content_type, StartsWith("text/csv"));
}

TEST_F(CaseRoutesTest, HistoryHasTheFormatThatTheAcceptHeaderPrefers) {
  const std::string id = submit_and_complete_one();
  const std::string path = "/v1/cases/" + cases(id)[0]["id"].get<std::string>() + "/history";
  const auto type = [&](const std::string& accept) { return get(path, {}, accept).content_type; };
  for (const char* accept : {"text/csv", "TEXT/CSV", "text/*", "application/json;q=0.5, text/csv",
                             "text/html, Text/CSV ; q=0.9, */*;q=0.1"})
    EXPECT_THAT(type(accept), StartsWith("text/csv")) << accept;
  for (const char* accept :
       {"", "*/*", "application/json", "text/csv;q=0.5, application/json", "text/csv;q=0", "text/csv, */*",
        "text/csvx", "text/html", "text/csv;q=0.1, */*;q=0.2"})
    EXPECT_EQ(type(accept), "application/json") << accept;
  EXPECT_EQ(get(path).headers.at("Vary"), "Accept");
}

TEST_F(CaseRoutesTest, WhyNamesWhatACaseWaitsFor) {
  const std::string document = study_document("w", {{"Ca", {1, 2, 3}}}).dump();
  const std::string id = json(ask("POST", "/v1/studies", document))["id"];
  service_->tick();
  const ordered_json found = json(get("/v1/studies/" + id + "/cases"))["cases"];
  const auto why = [&](int index) {
    return json(get("/v1/cases/" + found[index]["id"].get<std::string>() + "/why"))["reasons"].dump();
  };
  EXPECT_THAT(why(0), HasSubstr("it runs since"));
  EXPECT_THAT(
      why(2),
      HasSubstr("0 cases are before it, 0 other studies take turns or go first, and 2 cases run on 2"));
  ask("POST", "/v1/studies/" + id + "/pause");
  EXPECT_THAT(why(2), HasSubstr("is paused"));
}

TEST_F(CaseRoutesTest, LogThatIsNotUtf8DoesNotBreakTheResponse) {
  const std::string id = submit_and_complete_one();
  std::ofstream(directory_of("run 2").log_file()) << "\xff\xfe";
  executor_.exit("run 2", 2);
  service_->tick();
  EXPECT_THAT(get("/v1/studies/" + id + "/cases").body, HasSubstr("the solver refused the case"));
}

}  // namespace
}  // namespace capstan
