// The HTTP API on real connections: sizes, encodings, methods, and retries at another fidelity.
#include <gtest/gtest.h>
#include <httplib.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::json;

class HttpTest : public ::testing::Test {
 protected:
  httplib::Result post(const std::string& body, const httplib::Headers& headers = {}) {
    return client_.Post("/v1/studies", headers, body, "application/json");
  }
  std::size_t number_of_studies() { return json::parse(client_.Get("/v1/studies")->body)["studies"].size(); }

  TemporaryDirectory data_;
  Daemon daemon_{data_.path()};
  httplib::Client client_{daemon_.url()};
};

TEST_F(HttpTest, EveryInvalidStudyIsAnsweredWithAProblemThatListsItsIssues) {
  const std::string grid =
      R"({"name": "a", "base": {"Ca": 0.1}, "axes": {"V": {"from": 1, "to": 2, "count": 1000},
                               "E_b": {"from": 0, "to": 1, "count": 1000}}})";
  for (const std::string& bad : {std::string(R"({"name": "a", "base": {"Ca": "high", "V": -1}})"),
                                 std::string(R"({"name": "a", "base": {"Ca": NaN}})"),
                                 std::string(R"({"name": "a", "base": {"Ca": -0.1}})"),
                                 std::string(R"({"name": "a", "base": {"Ca": 1}, "key": 1})"),
                                 std::string(R"({"name": "a", "base": {"Ca": 1)"), std::string(100000, '['),
                                 std::string("\xff\xfe"), std::string(), grid}) {
    const auto answer = post(bad);
    ASSERT_TRUE(answer) << bad.substr(0, 80);
    EXPECT_EQ(answer->status, 422) << bad.substr(0, 80);
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
    EXPECT_FALSE(json::parse(answer->body)["errors"].empty());
  }
  EXPECT_EQ(number_of_studies(), 0u);
}

TEST_F(HttpTest, PlanIsAnsweredWithoutSubmittingAnything) {
  const auto plan = [&](const std::string& body) {
    return client_.Post("/v1/plan", body, "application/json");
  };
  const auto answer = plan(study_document("planned", {{"Ca", {0.25, 0.75}}, {"V", {1, 4}}}).dump());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  const json study = json::parse(answer->body);
  EXPECT_EQ(study["cases"], 4);
  EXPECT_EQ(study["groups"].size(), 2u);
  EXPECT_GT(study["seconds"]["total"], 0);
  EXPECT_FALSE(study["groups"][0]["left_out"].empty());
  EXPECT_EQ(plan(R"({"Ca": -1})")->status, 422);
  EXPECT_EQ(client_.Get("/v1/plan")->status, 405);
  EXPECT_EQ(number_of_studies(), 0u);
}

TEST_F(HttpTest, BodyOverOneMebibyteIsTooLarge) {
  const auto answer = post(std::string((1 << 20) + 1, ' '));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 413);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
}

TEST_F(HttpTest, ChunkedBodyIsRefusedUnread) {
  const auto drip = [](std::size_t, httplib::DataSink& sink) {
    sink.write("{}", 2);
    sink.done();
    return true;
  };
  const auto answer = client_.Post("/v1/studies", drip, "application/json");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 411);
}

TEST_F(HttpTest, CompressedBodyIsRefusedUnread) {
  const auto answer = post("anything", {{"Content-Encoding", "gzip"}});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 415);
}

TEST_F(HttpTest, LongPathIsRefused) {
  const auto answer = client_.Get("/v1/studies/" + std::string(5000, 'a'));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 414);
}

TEST_F(HttpTest, OtherMethodsOfAKnownPathAreNotAllowed) {
  for (const auto& answer : {client_.Put("/v1/studies", "", ""), client_.Delete("/v1/studies"),
                             client_.Patch("/v1/studies", "", ""), client_.Options("/v1/studies")}) {
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 405);
    EXPECT_EQ(answer->get_header_value("Allow"), "POST, GET");
  }
}

TEST_F(HttpTest, FilterInTheQueryIsDecoded) {
  const json study = json::parse(post(study_document("http", {{"Ca", {0.25}}}).dump())->body);
  const std::string cases = study["links"]["cases"];
  EXPECT_EQ(json::parse(client_.Get(cases + "?Ca=2.5e%2D1")->body)["cases"].size(), 1u);
}

/// Three cases: one completes, one diverges and one is refused by the solver; the latter two complete at a
/// finer fidelity.
class RetryTest : public HttpTest {
 protected:
  RetryTest() {
    const json document = study_document("retry", {{"V", {4, 55, 95}}, {"Ca", {0.25}}});
    id_ = api_.post("/v1/studies", document.dump())["id"];
    wait_for(api_, "/v1/studies/" + id_, [](const auto& study) {
      return study["cases"]["done"] == 1 && study["cases"]["diverged"] == 1 && study["cases"]["failed"] == 1;
    });
  }
  httplib::Result retry(const std::string& id, const std::string& body) {
    return client_.Post("/v1/studies/" + id + "/retry", body, "application/json");
  }
  nlohmann::ordered_json cases() { return api_.get("/v1/studies/" + id_ + "/cases")["cases"]; }

  Client api_{daemon_.url()};
  std::string id_;
};

TEST_F(RetryTest, AtAFinerFidelityReplacesFailedAndDivergedCases) {
  const nlohmann::ordered_json before = cases();
  const auto answer = retry(id_, R"({"fidelity": "fine"})");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(json::parse(answer->body)["id"], id_);
  wait_for_cases(api_, id_, "done", 3);
  const nlohmann::ordered_json after = cases();
  ASSERT_EQ(after.size(), 3u);
  EXPECT_EQ(after[0], before[0]);
  for (int i : {1, 2}) {
    EXPECT_EQ(after[i]["replaces"], before[i]["id"]);
    EXPECT_EQ(after[i]["parameters"]["V"], before[i]["parameters"]["V"]);
    EXPECT_GT(after[i]["parameters"]["fidelity"]["nodes"], before[i]["parameters"]["fidelity"]["nodes"]);
    EXPECT_EQ(after[i]["motion"], "tumbling");
  }
}

TEST_F(RetryTest, AtAnInvalidFidelityIsAProblemThatListsAllIssuesAndChangesNothing) {
  const nlohmann::ordered_json before = cases();
  const auto answer = retry(id_, R"({"fidelity": {"nodes": 7, "colour": "red"}})");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 422);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
  std::set<std::string> pointers;
  const json problem = json::parse(answer->body);
  for (const json& issue : problem["errors"]) pointers.insert(issue["pointer"]);
  EXPECT_EQ(pointers, (std::set<std::string>{"/fidelity/nodes", "/fidelity/colour"}));
  for (const char* bad : {"{", "[]", "{}", "\"fine\"", R"({"fidelity": "finest"})", R"({"fidelity": null})"})
    EXPECT_EQ(retry(id_, bad)->status, 422) << bad;
  EXPECT_EQ(cases(), before);
}

TEST_F(RetryTest, OfAnUnknownStudyIsNotFound) {
  for (const char* body : {"", R"({"fidelity": "fine"})", R"({"fidelity": "finest"})"}) {
    const auto answer = retry("nothing-0000", body);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 404) << body;
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
  }
}

}  // namespace
}  // namespace capstan
