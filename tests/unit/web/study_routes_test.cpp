// What the routes of studies answer.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

class StudyRoutesTest : public RouteFixture {};

TEST_F(StudyRoutesTest, NewStudyIsCreatedAndLinksToItsParts) {
  const Response response = ask("POST", "/v1/studies", study_document("api", {{"Ca", {0.25, 0.75}}}).dump());
  EXPECT_EQ(response.status, 201);
  const ordered_json study = json(response);
  EXPECT_THAT(study["id"].get<std::string>(), StartsWith("api-"));
  EXPECT_EQ(study["cases"]["queued"], 2);
  EXPECT_EQ(response.headers.at("Location"), study["links"]["self"]);
  EXPECT_EQ(get(study["links"]["self"]).status, 200);
  EXPECT_EQ(get(study["links"]["cases"]).status, 200);
  EXPECT_EQ(get(study["links"]["phase_diagram"]).status, 200);
}

TEST_F(StudyRoutesTest, SameStudyAgainIsFoundNotCreated) {
  const std::string document = study_document("api", {{"Ca", {0.25}}}).dump();
  const Response first = ask("POST", "/v1/studies", document);
  const Response second = ask("POST", "/v1/studies", document);
  EXPECT_EQ(second.status, 200);
  EXPECT_EQ(json(first)["id"], json(second)["id"]);
  EXPECT_THAT(json(get("/v1/studies"))["studies"], SizeIs(1));
}

TEST_F(StudyRoutesTest, InvalidStudyIsRefusedWithAllIssuesAndQueuesNothing) {
  const Response response =
      ask("POST", "/v1/studies",
          study_document("api", {{"Ca", {0.25, -1}}, {"V", {"thick"}}, {"Q", {1}}}).dump());
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(response.content_type, "application/problem+json");
  std::set<std::string> pointers;
  const ordered_json body = json(response);
  for (const ordered_json& error : body["errors"]) pointers.insert(error["pointer"]);
  EXPECT_THAT(pointers, ElementsAre("/axes/Ca/1", "/axes/Q", "/axes/V/0"));
  EXPECT_THAT(json(get("/v1/studies"))["studies"], SizeIs(0));
}

TEST_F(StudyRoutesTest, PlanOfAStudyOrACaseStoresNothing) {
  const Response study = ask("POST", "/v1/plan", study_document("api", {{"Ca", {0.25, 0.75}}}).dump());
  EXPECT_EQ(study.status, 200);
  EXPECT_EQ(json(study)["kind"], "study");
  EXPECT_EQ(json(study)["cases"], 2);
  const Response single = ask("POST", "/v1/plan", R"({"Ca": 0.1})");
  EXPECT_EQ(single.status, 200);
  EXPECT_EQ(json(single)["kind"], "case");
  EXPECT_THAT(json(get("/v1/studies"))["studies"], SizeIs(0));
}

TEST_F(StudyRoutesTest, PlanOfAnInvalidDocumentIsRefusedWithItsIssues) {
  for (const char* bad : {R"({"Ca": -1})", R"({"name": "a", "base": {"Ca": -1}})", "", "[]", "{"}) {
    const Response response = ask("POST", "/v1/plan", bad);
    EXPECT_EQ(response.status, 422) << bad;
    EXPECT_FALSE(json(response)["errors"].empty()) << bad;
  }
  nlohmann::json many = {{"Ca", 0.1}};
  for (int i = 0; i < 1000; ++i) many["unknown" + std::to_string(i)] = 1;
  EXPECT_THAT(json(ask("POST", "/v1/plan", many.dump()))["errors"], SizeIs(101));
}

TEST_F(StudyRoutesTest, EveryTruncationOfAStudyIsRefused) {
  const std::string document = study_document("api", {{"Ca", {0.25}}}).dump();
  for (std::size_t length = 0; length < document.size(); ++length)
    EXPECT_EQ(ask("POST", "/v1/studies", document.substr(0, length)).status, 422) << length;
}

TEST_F(StudyRoutesTest, IdempotencyKeyOfAnotherStudyIsRefused) {
  httplib::Request request =
      request_for("POST", "/v1/studies", {}, study_document("a", {{"Ca", {1}}}).dump());
  request.set_header("Idempotency-Key", "once");
  EXPECT_EQ(respond(*service_, request).status, 201);
  EXPECT_EQ(respond(*service_, request).status, 200);
  request.body = study_document("b", {{"Ca", {1}}}).dump();
  EXPECT_EQ(respond(*service_, request).status, 422);
}

TEST_F(StudyRoutesTest, LongIdempotencyKeyIsRefused) {
  httplib::Request request =
      request_for("POST", "/v1/studies", {}, study_document("a", {{"Ca", {1}}}).dump());
  request.set_header("Idempotency-Key", std::string(201, 'a'));
  EXPECT_EQ(respond(*service_, request).status, 400);
}

TEST_F(StudyRoutesTest, ListsAreReturnedInPages) {
  const std::string id =
      json(ask("POST", "/v1/studies", study_document("a", {{"Ca", {1, 2, 3}}}).dump()))["id"];
  const std::string path = "/v1/studies/" + id + "/cases";
  const ordered_json first = json(get(path, {{"limit", "2"}}));
  EXPECT_THAT(first["cases"], SizeIs(2));
  const ordered_json second = json(get(path, {{"limit", "2"}, {"after", first["next"]}}));
  EXPECT_THAT(second["cases"], SizeIs(1));
  EXPECT_EQ(second["cases"][0]["parameters"]["Ca"], 3);
  EXPECT_TRUE(second["next"].is_null());
  EXPECT_EQ(get(path, {{"limit", "0"}}).status, 400);
  EXPECT_EQ(get(path, {{"after", "x"}}).status, 400);
  EXPECT_EQ(get(path, {{"after", first["next"].get<std::string>() + "x"}}).status, 400);
  EXPECT_EQ(get("/v1/studies", {{"after", first["next"]}}).status, 400) << "the cursor of another list";
  EXPECT_EQ(get(path, {{"V", "1"}, {"after", first["next"]}}).status, 400) << "the cursor of another filter";
  ask("POST", "/v1/studies", study_document("b", {{"Ca", {1}}}).dump());
  const ordered_json newest = json(get("/v1/studies", {{"limit", "1"}}));
  EXPECT_EQ(newest["studies"][0]["name"], "b");
  EXPECT_EQ(json(get("/v1/studies", {{"after", newest["next"]}}))["studies"][0]["name"], "a");
}

TEST_F(StudyRoutesTest, LongDescriptionIsCompleteInTheStudyAndCutInTheList) {
  nlohmann::json document = study_document("long", {{"Ca", {0.25}}});
  std::string description(199, 'a');
  for (int i = 0; i < 100'000; ++i) description += "\xc3\xa9";
  document["description"] = description;
  const std::string id = json(ask("POST", "/v1/studies", document.dump()))["id"];
  EXPECT_EQ(json(get("/v1/studies/" + id))["description"], description);
  EXPECT_EQ(json(get("/v1/studies"))["studies"][0]["description"], std::string(199, 'a') + "...");
}

TEST_F(StudyRoutesTest, StudyIsCancelled) {
  const std::string id = submit_and_complete_one();
  const ordered_json study = json(ask("POST", "/v1/studies/" + id + "/cancel"));
  EXPECT_EQ(study["cancelled"], true);
  service_->tick();
  EXPECT_EQ(executor_.asked_to_stop.size(), 1u);
}

TEST_F(StudyRoutesTest, StudyIsPausedResumedRetriedAndGivenAPriority) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  EXPECT_EQ(json(ask("POST", path + "/pause"))["paused"], true);
  EXPECT_EQ(json(ask("POST", path + "/resume"))["paused"], false);
  EXPECT_EQ(ask("POST", path + "/retry").status, 200);
  EXPECT_EQ(json(ask("POST", path + "/priority", R"({"priority": 7})"))["priority"], 7);
  for (const char* bad : {"", "7", "{}", R"({"priority": 1.5})", R"({"priority": 101})"})
    EXPECT_EQ(ask("POST", path + "/priority", bad).status, 422) << bad;
}

TEST_F(StudyRoutesTest, DeletedStudyIsNotFoundAnyMore) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  const std::string case_path =
      "/v1/cases/" + json(get(path + "/cases"))["cases"][0]["id"].get<std::string>();
  const ordered_json deleted = json(ask("DELETE", path));
  EXPECT_EQ(deleted["deleted_cases"], 2);
  EXPECT_EQ(deleted["kept_cases"], 0);
  EXPECT_EQ(get(path).status, 404);
  EXPECT_EQ(ask("DELETE", path).status, 404);
  service_->tick();
  EXPECT_EQ(get(case_path).status, 404);
}

TEST_F(StudyRoutesTest, ThirdAxisOfAPhaseDiagramIsFixed) {
  const std::string id = json(
      ask("POST", "/v1/studies",
          study_document("three", {{"Ca", {0.1, 0.2}}, {"V", {1, 2}}, {"E_b", {0, 0.01}}}).dump()))["id"];
  const std::string path = "/v1/studies/" + id + "/phase-diagram";
  const Response refusal = get(path);
  EXPECT_EQ(refusal.status, 400);
  EXPECT_THAT(refusal.body, HasSubstr("E_b is not fixed"));
  EXPECT_THAT(refusal.body, HasSubstr("it has: 0, 0.01"));
  const Response response = get(path, {{"x", "V"}, {"y", "E_b"}, {"at", "Ca=0.2"}});
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(json(response)["at"]["Ca"], 0.2);
  EXPECT_THAT(json(response)["rows"], SizeIs(2));
  EXPECT_EQ(get(path, {{"at", "E_b=0.3"}}).status, 400);
}

TEST_F(StudyRoutesTest, PhaseDiagramHasTheMotionOfEachCell) {
  const ordered_json diagram = json(get("/v1/studies/" + submit_and_complete_one() + "/phase-diagram"));
  EXPECT_EQ(diagram["x"]["parameter"], "Ca");
  EXPECT_EQ(diagram["y"]["values"], ordered_json({4}));
  EXPECT_EQ(diagram["rows"][0][0]["motion"], "tumbling");
  EXPECT_EQ(diagram["rows"][0][1]["state"], "running");
}

TEST_F(StudyRoutesTest, CasesAreOneTableAsCsvWithoutPages) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/cases";
  const std::string table = get(path, {{"format", "csv"}}).body;
  EXPECT_THAT(table, StartsWith("id,state,motion,"));
  EXPECT_EQ(std::ranges::count(table, '\n'), 3) << "a header and two points";
  EXPECT_EQ(get(path, {}, "text/csv").body, table);
  EXPECT_EQ(std::ranges::count(get(path, {{"format", "csv"}, {"motion", "tumbling"}}).body, '\n'), 2);
}

TEST_F(StudyRoutesTest, HistoriesAreOnOneTimeGrid) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/histories";
  const ordered_json found = json(get(path, {{"every", "7.5"}, {"columns", "theta,D_xy"}}));
  EXPECT_EQ(found["kt"], ordered_json({0.0, 7.5, 15.0, 22.5, 30.0}));
  ASSERT_THAT(found["points"], SizeIs(2));
  EXPECT_EQ(found["points"][0]["point"], 1);
  EXPECT_EQ(found["points"][0]["asked"]["Ca"], 0.25);
  EXPECT_EQ(found["points"][0]["history"]["theta"], ordered_json({nullptr, nullptr, 0.5, -1.0, -2.5}))
      << "recorded at 15 and 30";
  EXPECT_EQ(found["points"][1]["history"]["theta"], ordered_json(5, nullptr)) << "not computed yet";
  EXPECT_THAT(found["points"][0]["history"], SizeIs(2)) << "the columns that were asked for";
  EXPECT_TRUE(found["next"].is_null());
  EXPECT_THAT(json(get(path))["kt"], SizeIs(301)) << "outputs.history_every is 0.1";
}

TEST_F(StudyRoutesTest, HistoriesAreFilteredAndReturnedInPages) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/histories";
  EXPECT_THAT(json(get(path, {{"motion", "tumbling"}}))["points"], SizeIs(1));
  const ordered_json first = json(get(path, {{"limit", "1"}}));
  EXPECT_THAT(first["points"], SizeIs(1));
  const ordered_json second = json(get(path, {{"limit", "1"}, {"after", first["next"]}}));
  EXPECT_EQ(second["points"][0]["point"], 2);
  EXPECT_EQ(second["kt"], first["kt"]);
  EXPECT_EQ(get(path, {{"every", "5"}, {"after", first["next"]}}).status, 400)
      << "the cursor of another grid";
}

TEST_F(StudyRoutesTest, HistoriesAsCsvHaveARowForEachPointAndTime) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/histories";
  const std::string table = get(path, {{"every", "15"}, {"columns", "theta"}, {"format", "csv"}}).body;
  EXPECT_EQ(table,
            "point,Ca,V,kt,theta\r\n"
            "1,0.25,4,0,\r\n1,0.25,4,15,0.5\r\n1,0.25,4,30,-2.5\r\n"
            "2,0.75,4,0,\r\n2,0.75,4,15,\r\n2,0.75,4,30,\r\n");
  EXPECT_EQ(get(path, {{"every", "15"}, {"columns", "theta"}}, "text/csv").body, table);
}

TEST_F(StudyRoutesTest, HistoriesThatWouldBeTooLongAreRefused) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/histories";
  for (const char* every : {"1e-3", "1e-300"}) {
    const Response refusal = get(path, {{"every", every}});
    EXPECT_EQ(refusal.status, 400) << every;
    EXPECT_THAT(refusal.body, HasSubstr("a grid has at most 10000 times"));
  }
  EXPECT_EQ(get(path, {{"every", "0.004"}}).status, 200);
}

TEST_F(StudyRoutesTest, PhaseDiagramAsCsvHasARowForEachPoint) {
  const std::string id = submit_and_complete_one();
  const std::string table = get("/v1/studies/" + id + "/phase-diagram", {{"format", "csv"}}).body;
  EXPECT_THAT(table, HasSubstr("Ca,motion,confirmed,state,case\r\n"));
  EXPECT_THAT(table, HasSubstr("0.25,tumbling,"));
  EXPECT_THAT(table, HasSubstr("0.75,,"));
}

const char* const kSought = R"({"name": "sought", "base": {"shape": "biconcave", "fidelity": "fast"},
  "boundary": {"along": "Ca", "between": [0.05, 1], "for": {"V": [2]}, "explore": 4}})";

TEST_F(StudyRoutesTest, BoundaryIsLinkedToAndAnsweredAsJsonOrCsv) {
  const ordered_json study = json(ask("POST", "/v1/studies", kSought));
  EXPECT_EQ(study["boundary"]["along"], "Ca");
  const std::string path = study["links"]["boundary"];
  const ordered_json boundary = json(get(path));
  EXPECT_EQ(boundary["points"]["asked"], 4);
  EXPECT_EQ(boundary["searching"], true);
  EXPECT_EQ(boundary["rows"][0]["at"]["V"], 2);
  const Response csv = get(path, {}, "text/csv");
  EXPECT_EQ(csv.content_type, "text/csv; charset=utf-8");
  EXPECT_THAT(csv.body, StartsWith("V,from,to,Ca,low,high,"));
  EXPECT_EQ(get(path, {{"format", "csv"}}).body, csv.body);
}

TEST_F(StudyRoutesTest, StudyThatSeeksNoBoundaryHasNone) {
  const std::string id = submit_and_complete_one();
  EXPECT_EQ(get("/v1/studies/" + id + "/boundary").status, 404);
  EXPECT_FALSE(json(get("/v1/studies/" + id))["links"].contains("boundary"));
  EXPECT_TRUE(json(get("/v1/studies/" + id))["boundary"].is_null());
}

}  // namespace
}  // namespace capstan
