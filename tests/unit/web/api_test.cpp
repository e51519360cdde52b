#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

#include "runner/web/routes.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

class ApiTest : public ServiceFixture {
 protected:
  Response ask(const std::string& method, const std::string& path, const std::string& body = "") {
    return respond(*service_, {method, path, {}, "", body});
  }
  Response get(const std::string& path, std::vector<std::pair<std::string, std::string>> query = {},
               const std::string& accept = "") {
    return respond(*service_, {"GET", path, std::move(query), accept, ""});
  }
  ordered_json json(const Response& response) { return ordered_json::parse(response.body); }

  /// A tumbling case at Ca = 0.25 and one without an answer at Ca = 0.75.
  std::string submit_and_complete_one() {
    const std::string document = study_document("api", {{"Ca", {0.25, 0.75}}, {"V", {4}}}).dump();
    const std::string id = json(ask("POST", "/v1/studies", document))["id"];
    service_->tick();
    write_history("run 1", "{\"kt\":15,\"theta\":0.5}\n{\"kt\":30,\"theta\":-2.5}\n");
    complete("run 1", "tumbling");
    service_->tick();
    return id;
  }
};

TEST_F(ApiTest, HealthNamesTheProgram) { EXPECT_EQ(json(get("/healthz"))["program"], "capstan"); }

/// Of the histories the first page is damaged; all else can be read.
TEST_F(ApiTest, DamagedDatabaseIsNotReadyAndTakesNoStudyOnceTheDamageIsSeen) {
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

TEST_F(ApiTest, NewStudyIsCreatedAndLinksToItsParts) {
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

TEST_F(ApiTest, SameStudyAgainIsFoundNotCreated) {
  const std::string document = study_document("api", {{"Ca", {0.25}}}).dump();
  const Response first = ask("POST", "/v1/studies", document);
  const Response second = ask("POST", "/v1/studies", document);
  EXPECT_EQ(second.status, 200);
  EXPECT_EQ(json(first)["id"], json(second)["id"]);
  EXPECT_THAT(json(get("/v1/studies"))["studies"], SizeIs(1));
}

TEST_F(ApiTest, InvalidStudyIsRefusedWithAllFaultsAndQueuesNothing) {
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

TEST_F(ApiTest, EveryTruncationOfAStudyIsRefused) {
  const std::string document = study_document("api", {{"Ca", {0.25}}}).dump();
  for (std::size_t length = 0; length < document.size(); ++length)
    EXPECT_EQ(ask("POST", "/v1/studies", document.substr(0, length)).status, 422) << length;
}

TEST_F(ApiTest, CaseSaysItsMotionAndTheEvidence) {
  const ordered_json found = json(get("/v1/studies/" + submit_and_complete_one() + "/cases"))["cases"];
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0]["motion"], "tumbling");
  EXPECT_EQ(found[0]["evidence"]["turns"], 2);
  EXPECT_EQ(found[0]["parameters"]["Ca"], 0.25);
  EXPECT_TRUE(found[1]["motion"].is_null());
  EXPECT_EQ(json(get("/v1/cases/" + found[0]["id"].get<std::string>()))["attempts"][0]["ending"], "done");
}

TEST_F(ApiTest, CasesAreFilteredByMotionStateAndParameters) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/cases";
  const auto count = [&](std::vector<std::pair<std::string, std::string>> query) {
    return json(get(path, std::move(query)))["cases"].size();
  };
  EXPECT_EQ(count({{"motion", "tumbling"}}), 1u);
  EXPECT_EQ(count({{"motion", "tank_treading"}}), 0u);
  EXPECT_EQ(count({{"state", "running"}, {"Ca", "0.75"}}), 1u);
  EXPECT_EQ(count({{"Ca", "0.2500"}, {"V", "4"}}), 1u);
  EXPECT_EQ(count({{"Ca", "0.25"}, {"V", "5"}}), 0u);
  EXPECT_EQ(count({{"shape", "biconcave"}}), 2u);
  EXPECT_EQ(count({{"shape", "sphere"}}), 0u);
}

TEST_F(ApiTest, FilterThatCannotBeMetIsRefused) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/cases";
  EXPECT_EQ(get(path, {{"colour", "red"}}).status, 400);
  EXPECT_EQ(get(path, {{"motion", "flying"}}).status, 400);
  EXPECT_EQ(get(path, {{"fidelity", "finest"}}).status, 400);
  EXPECT_EQ(get(path, {{"Ca') OR 1 --", "1"}}).status, 400);
}

TEST_F(ApiTest, QueryThatMakesNoSenseIsRefusedWithWhatIsAllowed) {
  const std::string study = "/v1/studies/" + submit_and_complete_one();
  const std::string history = "/v1/cases/" + cases(study.substr(12))[0]["id"].get<std::string>() + "/history";
  const std::vector<std::tuple<std::string, Query, std::string>> bad = {
      {study + "/cases", {{"Ca", "abc"}}, "must be a number"},
      {study + "/cases", {{"Ca", "nan"}}, "must be a number"},
      {study + "/cases", {{"V", "inf"}}, "must be a number"},
      {study + "/cases", {{"Re", "0.1x"}}, "must be a number"},
      {study + "/cases", {{"c0", "unifrom"}}, "initial, uniform"},
      {study + "/cases", {{"shape", "spher"}}, "must be one of: sphere, oblate, prolate, biconcave"},
      {study + "/cases", {{"law", "Skalak"}}, "must be one of: neo-hookean, skalak"},
      {study + "/cases", {{"bending", "x"}}, "must be one of: variational"},
      {study + "/cases", {{"fluid", "water"}}, "must be one of: quasisteady, transient, stokes, auto"},
      {study + "/cases", {{"state", "Done"}}, "must be one of: queued"},
      {study + "/cases", {{"Ca", "0.25"}, {"Ca", "0.25"}}, "stands twice"},
      {study + "/cases", {{"Ca", ""}}, "has no value"},
      {study + "/cases",
       {{"fidelity", "Fast"}},
       "must be one of: fast, standard, fine, paper; or an object of knobs"},
      {study + "/cases", {{"ca", "0.25"}}, "is unknown; there are: limit, after, state, motion"},
      {study + "/cases", {{"limit", "0"}}, "must be a whole number from 1 to 1000"},
      {study + "/cases", {{"limit", "1e3"}}, "must be a whole number from 1 to 1000"},
      {study + "/phase-diagram", {{"x", "colour"}}, "must be one of: shape"},
      {study + "/phase-diagram", {{"z", "Ca"}}, "is unknown"},
      {study + "/events", {{"since", "1"}}, "there are no parameters here"},
      {study, {{"verbose", "1"}}, "there are no parameters here"},
      {history, {{"format", "xml"}}, "must be one of: json, csv"},
      {"/v1/studies", {{"name", "a"}}, "is unknown; there are: limit, after"},
      {"/healthz", {{"a", "b"}}, "there are no parameters here"},
      {"/metrics", {{"", "b"}}, "there are no parameters here"},
  };
  for (const auto& [path, query, said] : bad) {
    const Response response = get(path, query);
    EXPECT_EQ(response.status, 400) << path << " " << query[0].first << "=" << query[0].second;
    EXPECT_EQ(response.content_type, "application/problem+json");
    EXPECT_THAT(json(response)["errors"].dump(), HasSubstr(said));
  }
  EXPECT_EQ(get(study + "/cases", {{"c0", "uniform"}, {"fluid", "auto"}, {"Ca", "2.5e-1"}}).status, 200);
}

TEST_F(ApiTest, NoRouteIgnoresAParameterThatItDoesNotKnow) {
  const std::string id = submit_and_complete_one();
  for (const Route& route : routes()) {
    std::string path(route.path);
    if (path.find("{id}") != path.npos) path.replace(path.find("{id}"), 4, id);
    Request request{std::string(route.method), path, {{"no_such_parameter", "1"}}, "", ""};
    EXPECT_EQ(respond(*service_, request).status, 400) << route.path;
  }
}

TEST_F(ApiTest, BodyThatARouteDoesNotTakeIsRefusedAndChangesNothing) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  for (const char* change : {"/cancel", "/pause", "/resume", "/retry"})
    for (const char* bad : {"{", "[]", "null", "nonsense", R"({"why": 1})", R"({"a": 1, "a": 1})"}) {
      const Response response = ask("POST", path + change, bad);
      EXPECT_EQ(response.status, 422) << change << bad;
      EXPECT_FALSE(json(response)["errors"].empty()) << change << bad;
    }
  EXPECT_EQ(ask("POST", path + "/retry", R"({"fidelity": "fine", "when": "now"})").status, 422);
  for (const char* bad : {R"({"fidelity": "Fine"})", R"({"fidelity": ""})", R"({"fidelity": 5})",
                          R"({"fidelity": {"nodes": 7}})"})
    EXPECT_EQ(ask("POST", path + "/retry", bad).status, 422) << bad << ": also where no case has failed";
  EXPECT_EQ(ask("POST", path + "/priority", R"({"priority": 1, "when": "now"})").status, 422);
  EXPECT_EQ(ask("GET", path, "{\"a\": 1}").status, 422);
  const ordered_json study = json(get(path));
  EXPECT_EQ(study["cancelled"], false);
  EXPECT_EQ(study["paused"], false);
  EXPECT_EQ(study["priority"], 0);
  EXPECT_EQ(json(ask("POST", path + "/pause", "{}"))["paused"], true);
}

TEST_F(ApiTest, IdInThePathMayHoldAnyCharacter) {
  submit_and_complete_one();
  for (const char* id : {"a%2Fcases", "%2e%2e", "a%00b", "%ff", "a%20b", "%3Cb%3E"}) {
    const Response response = get("/v1/studies/" + std::string(id));
    EXPECT_EQ(response.status, 404) << id;
    EXPECT_THAT(json(response)["detail"].get<std::string>(), HasSubstr("there is no study")) << id;
  }
  EXPECT_EQ(get("/v1/%73tudies").status, 200);
}

TEST_F(ApiTest, HistoryComesInTheFormatThatTheClientPrefers) {
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

TEST_F(ApiTest, PointsAreShownFilteredAndDrawnByWhatWasAskedFor) {
  const Response response = ask("POST", "/v1/studies", R"({"name": "asked", "base": {"Ca": 0.1},
      "axes": {"fluid": ["stokes", "auto", "quasisteady"], "fidelity": ["fast", {"preset": "fast", "nodes": 162}]}})");
  ASSERT_EQ(response.status, 201) << response.body;
  const ordered_json study = json(response);
  EXPECT_EQ(study["points"], 6);
  EXPECT_EQ(study["cases"]["total"], 4);
  EXPECT_THAT(study["notes"].dump(), HasSubstr("6 points are 4 cases"));
  const std::string path = "/v1/studies/" + study["id"].get<std::string>();
  const auto points = [&](std::vector<std::pair<std::string, std::string>> query) {
    return json(get(path + "/cases", std::move(query)))["cases"];
  };
  const ordered_json automatic = points({{"fluid", "auto"}});
  ASSERT_THAT(automatic, SizeIs(2));
  EXPECT_EQ(automatic[0]["point"], 3);
  EXPECT_EQ(automatic[0].value("same_as", 0), 1);
  EXPECT_EQ(automatic[0]["asked"]["fluid"], "auto");
  EXPECT_EQ(automatic[0]["asked"]["fidelity"], "fast");
  EXPECT_EQ(automatic[0]["parameters"]["fluid"], "stokes");
  EXPECT_THAT(points({{"fluid", "stokes"}}), SizeIs(2)) << "what was asked for, not what auto became";
  EXPECT_THAT(points({{"fidelity", "fast"}}), SizeIs(3));
  EXPECT_THAT(points({{"fidelity", R"({"nodes": 162, "preset": "fast"})"}, {"fluid", "auto"}}), SizeIs(1));
  EXPECT_THAT(points({{"shape", "sphere"}}), SizeIs(6)) << "a default that nobody asked for";
  const ordered_json diagram = json(get(path + "/phase-diagram"));
  EXPECT_EQ(diagram["x"]["values"], ordered_json({"stokes", "auto", "quasisteady"}));
  for (const ordered_json& row : diagram["rows"])
    for (const ordered_json& cell : row) EXPECT_EQ(cell["state"], "queued");
}

TEST_F(ApiTest, PointSaysWhichOfItsKeysHaveNoEffect) {
  const std::string id = json(ask("POST", "/v1/studies", R"({"name": "asked", "base": {"Ca": 0.1},
      "axes": {"fluid": ["stokes", "quasisteady"], "Re": [0.02, 0.05]}})"))["id"];
  const ordered_json points = json(get("/v1/studies/" + id + "/cases"))["cases"];
  ASSERT_THAT(points, SizeIs(4));
  EXPECT_EQ(points[0]["without_effect"], ordered_json({"Re"}));
  EXPECT_FALSE(points[1].contains("without_effect"));
  EXPECT_FALSE(points[1].contains("same_as"));
  EXPECT_EQ(points[2].value("same_as", 0), 1);
}

TEST_F(ApiTest, FilterTellsCloseValuesOfAnAxisApart) {
  const std::string id = json(
      ask("POST", "/v1/studies",
          study_document("close", {{"Ca", {0.1}}, {"V", {{"from", 1}, {"to", 1.00000000001}, {"count", 11}}}})
              .dump()))["id"];
  const ordered_json points = json(get("/v1/studies/" + id + "/cases", {{"V", "1.000000000003"}}))["cases"];
  ASSERT_THAT(points, SizeIs(1));
  EXPECT_EQ(points[0]["point"], 4);
}

TEST_F(ApiTest, ThirdAxisOfAPhaseDiagramIsFixed) {
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

TEST_F(ApiTest, HistoryComesInColumnsOrAsCsv) {
  const std::string id = submit_and_complete_one();
  const std::string case_id = json(get("/v1/studies/" + id + "/cases"))["cases"][0]["id"];
  const std::string path = "/v1/cases/" + case_id + "/history";
  EXPECT_EQ(json(get(path))["kt"], ordered_json({15.0, 30.0}));
  EXPECT_EQ(json(get(path))["theta"], ordered_json({0.5, -2.5}));
  EXPECT_TRUE(json(get(path))["psi"][0].is_null());
  EXPECT_THAT(get(path, {{"format", "csv"}}).body, StartsWith("kt,D_xy,theta,psi,volume,area\r\n15,,0.5,"));
  EXPECT_THAT(get(path, {}, "text/csv").content_type, StartsWith("text/csv"));
}

TEST_F(ApiTest, PhaseDiagramHasTheMotionOfEachCell) {
  const ordered_json diagram = json(get("/v1/studies/" + submit_and_complete_one() + "/phase-diagram"));
  EXPECT_EQ(diagram["x"]["parameter"], "Ca");
  EXPECT_EQ(diagram["y"]["values"], ordered_json({4}));
  EXPECT_EQ(diagram["rows"][0][0]["motion"], "tumbling");
  EXPECT_EQ(diagram["rows"][0][1]["state"], "running");
}

TEST_F(ApiTest, DeletedStudyIsNotFoundAnyMore) {
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

TEST_F(ApiTest, LongDescriptionStandsInTheStudyAndNotInTheList) {
  nlohmann::json document = study_document("long", {{"Ca", {0.25}}});
  std::string description(199, 'a');
  for (int i = 0; i < 100'000; ++i) description += "\xc3\xa9";
  document["description"] = description;
  const std::string id = json(ask("POST", "/v1/studies", document.dump()))["id"];
  EXPECT_EQ(json(get("/v1/studies/" + id))["description"], description);
  EXPECT_EQ(json(get("/v1/studies"))["studies"][0]["description"], std::string(199, 'a') + "...");
}

TEST_F(ApiTest, StudyIsCancelled) {
  const std::string id = submit_and_complete_one();
  const ordered_json study = json(ask("POST", "/v1/studies/" + id + "/cancel"));
  EXPECT_EQ(study["cancelled"], true);
  service_->tick();
  EXPECT_EQ(executor_.asked_to_stop.size(), 1u);
}

TEST_F(ApiTest, RoutesAreExactlyThoseOfTheDocument) {
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

TEST_F(ApiTest, SchemasThatTheDocumentRefersToAreServedBesideIt) {
  const std::string document = get("/openapi.yaml").body;
  EXPECT_THAT(document, HasSubstr("$ref: study.schema.json"));
  const ordered_json study = json(get("/study.schema.json"));
  EXPECT_EQ(study["$id"], "study.schema.json");
  EXPECT_THAT(study["properties"]["base"].dump(), HasSubstr("case.schema.json#/properties/Ca"));
  EXPECT_TRUE(json(get("/case.schema.json"))["properties"].contains("Ca"));
}

TEST_F(ApiTest, ListsComeInPages) {
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

TEST_F(ApiTest, UnchangedAnswerIsNotSentAgain) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  const Response first = get(path);
  Request again{"GET", path, {}, "", ""};
  const std::string tag = first.headers.at("ETag");
  for (const std::string& known : {tag, "W/" + tag, "\"a\", " + tag, std::string("*")}) {
    again.if_none_match = known;
    const Response unchanged = respond(*service_, again);
    EXPECT_EQ(unchanged.status, 304) << known;
    EXPECT_EQ(unchanged.body, "");
    EXPECT_EQ(unchanged.headers.at("ETag"), tag);
  }
  again.if_none_match = "\"a\"";
  EXPECT_EQ(respond(*service_, again).status, 200);
  again.if_none_match = tag;
  ask("POST", path + "/pause");
  EXPECT_EQ(respond(*service_, again).status, 200);
}

TEST_F(ApiTest, KeyThatCameWithAnotherStudyIsRefused) {
  Request request{"POST", "/v1/studies", {}, "", study_document("a", {{"Ca", {1}}}).dump()};
  request.idempotency_key = "once";
  EXPECT_EQ(respond(*service_, request).status, 201);
  EXPECT_EQ(respond(*service_, request).status, 200);
  request.body = study_document("b", {{"Ca", {1}}}).dump();
  EXPECT_EQ(respond(*service_, request).status, 422);
}

TEST_F(ApiTest, OperatorPausesRetriesAndRanksAStudy) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  EXPECT_EQ(json(ask("POST", path + "/pause"))["paused"], true);
  EXPECT_EQ(json(ask("POST", path + "/resume"))["paused"], false);
  EXPECT_EQ(ask("POST", path + "/retry").status, 200);
  EXPECT_EQ(json(ask("POST", path + "/priority", R"({"priority": 7})"))["priority"], 7);
  for (const char* bad : {"", "7", "{}", R"({"priority": 1.5})", R"({"priority": 101})"})
    EXPECT_EQ(ask("POST", path + "/priority", bad).status, 422) << bad;
}

TEST_F(ApiTest, WhyNamesWhatACaseWaitsFor) {
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

TEST_F(ApiTest, MetricsCountCasesByState) {
  submit_and_complete_one();
  EXPECT_THAT(get("/metrics").body, HasSubstr("capstan_cases{state=\"done\"} 1\n"));
  EXPECT_THAT(get("/metrics").body, HasSubstr("capstan_attempts_total{ending=\"done\"} 1\n"));
}

TEST_F(ApiTest, EverySampleOfTheMetricsIsOfADescribedKind) {
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

TEST_F(ApiTest, CountersNeverFall) {
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

TEST_F(ApiTest, ServerIsReadyOnlyWhileItsDatabaseCanBeRead) {
  EXPECT_EQ(get("/readyz").status, 200);
  std::filesystem::rename(data_.database(), data_.path() / "gone");
  const Response response = get("/readyz");
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(response.content_type, "application/problem+json");
}

TEST_F(ApiTest, LongIdempotencyKeyIsRefused) {
  Request request{"POST", "/v1/studies", {}, "", study_document("a", {{"Ca", {1}}}).dump()};
  request.idempotency_key = std::string(201, 'a');
  EXPECT_EQ(respond(*service_, request).status, 400);
}

TEST_F(ApiTest, WhatIsNotThereIsNotFound) {
  for (const char* path :
       {"/", "/v1", "/v1/studies/nobody", "/v1/studies/nobody/cases", "/v1/studies/a/b/cases",
        "/v1/studies/nobody/phase-diagram", "/v1/cases/0123", "/v1/cases/0123/history", "/v1/cases/"})
    EXPECT_EQ(get(path).status, 404) << path;
  EXPECT_EQ(ask("POST", "/v1/studies/nobody/cancel").status, 404);
}

TEST_F(ApiTest, KnownPathAnswersOtherMethodsWithThoseItHas) {
  const Response response = ask("DELETE", "/v1/studies");
  EXPECT_EQ(response.status, 405);
  EXPECT_EQ(response.headers.at("Allow"), "POST, GET");
  EXPECT_EQ(get("/v1/studies/nobody/cancel").status, 405);
}

TEST_F(ApiTest, BytesThatAreNoTextBreakNoAnswer) {
  const std::string id = submit_and_complete_one();
  std::ofstream(directory_of("run 2").log_file()) << "\xff\xfe";
  executor_.exit("run 2", 2);
  service_->tick();
  EXPECT_THAT(get("/v1/studies/" + id + "/cases").body, HasSubstr("the solver refused the case"));
}

}  // namespace
}  // namespace capstan
