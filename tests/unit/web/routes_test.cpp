// What holds on every route.
#include <gmock/gmock.h>

#include <tuple>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

class RoutesTest : public RouteFixture {};

TEST_F(RoutesTest, InvalidQueryIsRefusedWithWhatIsAllowed) {
  const std::string study = "/v1/studies/" + submit_and_complete_one();
  const std::string history = "/v1/cases/" + cases(study.substr(12))[0]["id"].get<std::string>() + "/history";
  const std::vector<std::tuple<std::string, httplib::Params, std::string>> bad = {
      {study + "/cases", {{"Ca", "abc"}}, "must be a number"},
      {study + "/cases", {{"Ca", "nan"}}, "must be a number"},
      {study + "/cases", {{"V", "inf"}}, "must be a number"},
      {study + "/cases", {{"Re", "0.1x"}}, "must be a number"},
      {study + "/cases", {{"c0", "unifrom"}}, "initial, uniform"},
      {study + "/cases", {{"shape", "spher"}}, "must be one of: sphere, oblate, prolate, biconcave"},
      {study + "/cases", {{"law", "Skalak"}}, "must be one of: neo-hookean, skalak"},
      {study + "/cases", {{"bending", "x"}}, "must be one of: variational"},
      {study + "/cases",
       {{"fluid", "water"}},
       "must be one of: quasisteady, unsteady, transient, stokes, auto"},
      {study + "/cases", {{"state", "Done"}}, "must be one of: queued"},
      {study + "/cases", {{"Ca", "0.25"}, {"Ca", "0.25"}}, "stands twice"},
      {study + "/cases", {{"Ca", ""}}, "has no value"},
      {study + "/cases",
       {{"fidelity", "Fast"}},
       "must be one of: fast, standard, fine, paper; or an object of knobs"},
      {study + "/cases", {{"ca", "0.25"}}, "is unknown; there are: limit, after, format, state, motion"},
      {study + "/cases", {{"limit", "0"}}, "must be a whole number from 1 to 1000"},
      {study + "/cases", {{"limit", "1e3"}}, "must be a whole number from 1 to 1000"},
      {study + "/histories", {{"every", "0"}}, "must be a number above 0"},
      {study + "/histories", {{"every", "nan"}}, "must be a number above 0"},
      {study + "/histories", {{"columns", "D_xy,size"}}, "each must be one of: D_xy, theta"},
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
    EXPECT_EQ(response.status, 400) << path << " " << query.begin()->first << "=" << query.begin()->second;
    EXPECT_EQ(response.content_type, "application/problem+json");
    EXPECT_THAT(json(response)["errors"].dump(), HasSubstr(said));
  }
  EXPECT_EQ(get(study + "/cases", {{"c0", "uniform"}, {"fluid", "auto"}, {"Ca", "2.5e-1"}}).status, 200);
}

TEST_F(RoutesTest, InvalidFilterIsRefused) {
  const std::string path = "/v1/studies/" + submit_and_complete_one() + "/cases";
  EXPECT_EQ(get(path, {{"colour", "red"}}).status, 400);
  EXPECT_EQ(get(path, {{"motion", "flying"}}).status, 400);
  EXPECT_EQ(get(path, {{"fidelity", "finest"}}).status, 400);
  EXPECT_EQ(get(path, {{"Ca') OR 1 --", "1"}}).status, 400);
}

TEST_F(RoutesTest, NoRouteIgnoresAnUnknownParameter) {
  const std::string id = submit_and_complete_one();
  for (const Route& route : routes()) {
    std::string path(route.path);
    if (path.find("{id}") != path.npos) path.replace(path.find("{id}"), 4, id);
    const auto request = request_for(std::string(route.method), path, {{"no_such_parameter", "1"}});
    EXPECT_EQ(respond(*service_, request).status, 400) << route.path;
  }
}

TEST_F(RoutesTest, InvalidBodyIsRefusedAndChangesNothing) {
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

TEST_F(RoutesTest, IdInThePathMayContainAnyCharacter) {
  submit_and_complete_one();
  for (const char* id : {"a%2Fcases", "%2e%2e", "a%00b", "%ff", "a%20b", "%3Cb%3E"}) {
    const Response response = get("/v1/studies/" + std::string(id));
    EXPECT_EQ(response.status, 404) << id;
    EXPECT_THAT(json(response)["detail"].get<std::string>(), HasSubstr("there is no study")) << id;
  }
  EXPECT_EQ(get("/v1/%73tudies").status, 200);
}

TEST_F(RoutesTest, UnchangedResponseIsNotSentAgain) {
  const std::string path = "/v1/studies/" + submit_and_complete_one();
  const Response first = get(path);
  httplib::Request again = request_for("GET", path);
  const std::string tag = first.headers.at("ETag");
  for (const std::string& known : {tag, "W/" + tag, "\"a\", " + tag, std::string("*")}) {
    again.headers = {{"If-None-Match", known}};
    const Response unchanged = respond(*service_, again);
    EXPECT_EQ(unchanged.status, 304) << known;
    EXPECT_EQ(unchanged.body, "");
    EXPECT_EQ(unchanged.headers.at("ETag"), tag);
  }
  again.headers = {{"If-None-Match", "\"a\""}};
  EXPECT_EQ(respond(*service_, again).status, 200);
  again.headers = {{"If-None-Match", tag}};
  ask("POST", path + "/pause");
  EXPECT_EQ(respond(*service_, again).status, 200);
}

TEST_F(RoutesTest, UnknownPathsAndIdsAreNotFound) {
  for (const char* path :
       {"/page", "/page/", "/page/nobody.js", "/page/..%2Fpage.js", "/v1", "/v1/studies/nobody",
        "/v1/studies/nobody/cases", "/v1/studies/nobody/histories", "/v1/studies/a/b/cases",
        "/v1/studies/nobody/phase-diagram", "/v1/cases/0123", "/v1/cases/0123/history", "/v1/cases/"})
    EXPECT_EQ(get(path).status, 404) << path;
  EXPECT_EQ(ask("POST", "/v1/studies/nobody/cancel").status, 404);
}

TEST_F(RoutesTest, OtherMethodsOfAKnownPathAreNotAllowed) {
  const Response response = ask("DELETE", "/v1/studies");
  EXPECT_EQ(response.status, 405);
  EXPECT_EQ(response.headers.at("Allow"), "POST, GET");
  EXPECT_EQ(get("/v1/studies/nobody/cancel").status, 405);
}

}  // namespace
}  // namespace capstan
