// Access to the real daemon over HTTP: tokens, host names, streams of events, and its end while clients wait.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <thread>

#include "tests/support/file_bytes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/raw_connection.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kToken = "a-token-of-some-length";

/// Sets the token in the environment of the daemons and commands that are started while it lives.
struct TokenInEnvironment {
  TokenInEnvironment() { setenv("CAPSTAN_TOKEN", kToken, 1); }
  ~TokenInEnvironment() { unsetenv("CAPSTAN_TOKEN"); }
};

class HttpAccessTest : public ::testing::Test {
 protected:
  std::string ask(const Daemon& daemon, const std::string& request) {
    RawConnection connection(daemon.url());
    connection.send(request);
    return connection.receive_all();
  }
  TemporaryDirectory data_;
};

TEST_F(HttpAccessTest, AddressThatOtherMachinesCanReachNeedsAToken) {
  for (const char* address : {"0.0.0.0:0", "[::]:0"}) {
    const CommandResult refused =
        run_capstan("serve --data " + data_.path().string() + " --listen " + std::string(address));
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("CAPSTAN_TOKEN"));
  }
  const TokenInEnvironment token;
  const Daemon daemon(data_.path(), {"--listen", "0.0.0.0:0"});
  EXPECT_EQ(status_of(ask(daemon, request_text("GET", "/healthz"))), 401);
}

TEST_F(HttpAccessTest, TokenIsRequiredOnEveryRouteAndSentByEveryCommand) {
  const TokenInEnvironment token;
  const Daemon daemon(data_.path());
  for (const char* path : {"/healthz", "/readyz", "/metrics", "/openapi.yaml", "/v1/studies", "/nothing"})
    EXPECT_EQ(status_of(ask(daemon, request_text("GET", path))), 401) << path;
  const std::string field = "Authorization: Bearer " + std::string(kToken) + "\r\n";
  EXPECT_EQ(status_of(ask(daemon, request_text("GET", "/healthz", field))), 200);
  const std::filesystem::path study = data_.path() / "study.json";
  overwrite(study, study_document("access", {{"Ca", {0.25}}}).dump());
  const std::string server = " --server " + daemon.url();
  EXPECT_EQ(run_capstan("submit --watch " + study.string() + server).exit_code, 0);
  unsetenv("CAPSTAN_TOKEN");
  const CommandResult refused = run_capstan("studies" + server);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("Bearer"));
}

TEST_F(HttpAccessTest, TokenIsInNoLog) {
  const TokenInEnvironment token;
  const Daemon daemon(data_.path());
  ask(daemon,
      request_text("GET", "/v1/studies?limit=5", "Authorization: Bearer " + std::string(kToken) + "\r\n"));
  ask(daemon, "GET /\x1b[2J HTTP/1.1\r\n\r\n");
  const std::string log = file_bytes(data_.path() / "requests.log");
  EXPECT_THAT(log, HasSubstr(" 127.0.0.1 GET /v1/studies?limit=5 200 "));
  EXPECT_THAT(log, HasSubstr(" 127.0.0.1 - - 400 "));
  EXPECT_EQ(log.find(kToken), log.npos);
}

TEST_F(HttpAccessTest, NamesOfTheServerAreThoseThatWereGiven) {
  const Daemon daemon(data_.path(), {"--host", "capsules.example.org"});
  const auto status = [&](const std::string& host) {
    return status_of(ask(daemon, "GET /healthz HTTP/1.1\r\nHost: " + host + "\r\n\r\n"));
  };
  EXPECT_EQ(status("capsules.example.org"), 200);
  EXPECT_EQ(status("evil.example"), 421);
  EXPECT_EQ(status_of(ask(daemon, request_text("POST", "/v1/studies", "Origin: http://evil.example\r\n"))),
            403);
}

TEST_F(HttpAccessTest, AnyLoopbackAddressServesWithoutAToken) {
  const Daemon daemon(data_.path(), {"--listen", "127.0.0.2:0"});
  EXPECT_THAT(daemon.url(), StartsWith("http://127.0.0.2:"));
  EXPECT_EQ(run_capstan("studies --server " + daemon.url()).exit_code, 0);
}

TEST_F(HttpAccessTest, EveryResponseForbidsTypeSniffing) {
  const Daemon daemon(data_.path());
  for (const char* target : {"/healthz", "/nothing", "/v1/studies?a=b", "/v1/%"})
    EXPECT_THAT(ask(daemon, request_text("GET", target)),
                HasSubstr("\r\nX-Content-Type-Options: nosniff\r\n"));
}

TEST_F(HttpAccessTest, AnswerIsNeverCompressedSoThatItsTagHolds) {
  const Daemon daemon(data_.path());
  const std::string plain = ask(daemon, request_text("GET", "/openapi.yaml"));
  EXPECT_EQ(ask(daemon, request_text("GET", "/openapi.yaml", "Accept-Encoding: gzip, br\r\n")), plain);
  EXPECT_THAT(plain, HasSubstr("ETag: \""));
}

TEST_F(HttpAccessTest, StudyIsFollowedToItsEnd) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id =
      client.post("/v1/studies", study_document("access", {{"Ca", {0.25}}, {"V", {70}}}).dump())["id"];
  RawConnection follower(daemon.url());
  follower.send(request_text("GET", "/v1/studies/" + id + "/events"));
  EXPECT_THAT(follower.receive(15), StartsWith("HTTP/1.1 200 OK"));
  client.post("/v1/studies/" + id + "/cancel", "");
  const std::string rest = follower.receive_all();
  EXPECT_THAT(rest, HasSubstr("Content-Type: text/event-stream"));
  EXPECT_THAT(rest, HasSubstr("event: progress"));
  EXPECT_THAT(rest.substr(rest.rfind("event: ")), StartsWith("event: end\n"));
}

/// Eight streams use half of the threads; a ninth is refused with 503, and all other requests are answered.
TEST_F(HttpAccessTest, FollowersLeaveHalfOfTheThreadsFree) {
  const Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id =
      client.post("/v1/studies", study_document("access", {{"Ca", {0.25}}, {"V", {70}}}).dump())["id"];
  const std::string request = request_text("GET", "/v1/studies/" + id + "/events");
  std::vector<RawConnection> followers;
  for (int i = 0; i < 8; ++i) {
    followers.emplace_back(daemon.url());
    followers.back().send(request);
    ASSERT_EQ(status_of(followers.back().receive(15)), 200);
  }
  const std::string refused = ask(daemon, request);
  EXPECT_EQ(status_of(refused), 503);
  EXPECT_THAT(refused, HasSubstr("Retry-After: "));
  EXPECT_EQ(status_of(ask(daemon, request_text("GET", "/healthz"))), 200);
  followers.clear();  // their threads become free
  wait_for(client, "/v1/studies/" + id, [&](const auto&) {
    return ask(daemon, request_text("GET", "/metrics")).find("capstan_http_streams 0\n") != std::string::npos;
  });
}

TEST_F(HttpAccessTest, LogIsReopenedAtSighup) {
  Daemon daemon(data_.path());
  const std::filesystem::path log = data_.path() / "requests.log";
  ask(daemon, request_text("GET", "/healthz"));
  std::filesystem::rename(log, data_.path() / "moved.log");
  kill(daemon.pid(), SIGHUP);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!std::filesystem::exists(log) && std::chrono::steady_clock::now() < deadline)
    std::this_thread::yield();
  ask(daemon, request_text("GET", "/readyz"));
  EXPECT_THAT(file_bytes(log), HasSubstr("GET /readyz"));
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
}

/// Twelve large studies, which take the database seconds to store.
TEST_F(HttpAccessTest, EndDoesNotWaitForRequestsUnderWay) {
  Daemon daemon(data_.path());
  const std::string grid = R"({"from": 0.1, "to": 1, "count": 2000})";
  std::vector<RawConnection> clients;
  for (int i = 0; i < 12; ++i) {
    clients.emplace_back(daemon.url());
    clients.back().send(request_text("POST", "/v1/studies", "",
                                     "{\"name\": \"s" + std::to_string(i) + "\", \"base\": {\"V\": " +
                                         std::to_string(2 + i) + R"(}, "axes": {"Ca": )" + grid + "}}"));
  }
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  for (RawConnection& client : clients) EXPECT_NE(status_of(client.receive_all()), 400);
}

TEST_F(HttpAccessTest, RequestWithAnIncompleteBodyAtTheEndIsRefusedWith503) {
  Daemon daemon(data_.path());
  RawConnection client(daemon.url());
  client.send(
      "POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
      "99\r\n\r\n{");
  EXPECT_EQ(status_of(ask(daemon, request_text("GET", "/healthz"))), 200);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
  const std::string answer = client.receive_all();
  EXPECT_EQ(status_of(answer), 503);
  EXPECT_THAT(answer, HasSubstr("Retry-After: "));
}

TEST_F(HttpAccessTest, DeletionIsCompletedAfterADaemonThatWasKilledDuringIt) {
  std::string id;
  {
    Daemon daemon(data_.path(), {}, "deleted");
    Client client(daemon.url());
    id = client.post("/v1/studies", study_document("gone", {{"Ca", {0.25, 0.75}}}).dump())["id"];
    wait_for_cases(client, id, "done", 2);
    ask(daemon, request_text("DELETE", "/v1/studies/" + id));
    EXPECT_TRUE(daemon.ends_within(std::chrono::minutes(1)));
  }
  const Daemon daemon(data_.path());
  EXPECT_EQ(status_of(ask(daemon, request_text("GET", "/v1/studies/" + id))), 404);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!is_empty(data_.path() / "runs") && std::chrono::steady_clock::now() < deadline)
    std::this_thread::yield();
  EXPECT_TRUE(is_empty(data_.path() / "runs"));
}

TEST_F(HttpAccessTest, DaemonEndsAtOnceWhileClientsStayConnected) {
  Daemon daemon(data_.path());
  Client client(daemon.url());
  const std::string id =
      client.post("/v1/studies", study_document("access", {{"Ca", {0.25}}, {"V", {70}}}).dump())["id"];
  RawConnection silent(daemon.url()), follower(daemon.url());
  follower.send(request_text("GET", "/v1/studies/" + id + "/events"));
  EXPECT_EQ(status_of(follower.receive(15)), 200);
  EXPECT_EQ(daemon.end_with(SIGTERM), 0);
}

}  // namespace
}  // namespace capstan
