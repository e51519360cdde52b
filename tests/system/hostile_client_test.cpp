// Hostile clients. After each test the server still answers at once, its memory has not grown, no descriptor
// is left open and the results are unchanged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/support/process_usage.hpp"
#include "tests/support/program.hpp"
#include "tests/support/raw_connection.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::AnyOf;

class HostileClientTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Client client(daemon_.url());
    study_ = client.post("/v1/studies", study_document("kept", {{"Ca", {0.25, 0.75}}}).dump())["id"];
    wait_for_cases(client, study_, "done", 2);
    results_ = answer_to(request_text("GET", cases_path()));
    ASSERT_EQ(status_of(results_), 200);
    memory_mb_ = resident_mb(daemon_.pid());
    files_ = open_files(daemon_.pid());
  }

  void TearDown() override {
    Client client(daemon_.url());
    EXPECT_EQ(answer_to(request_text("GET", cases_path())), results_) << "no result is touched";
    EXPECT_EQ(client.get("/v1/studies")["studies"].size(), 1u) << "no study is added";
    EXPECT_LT(resident_mb(daemon_.pid()), memory_mb_ + 16) << "memory stays flat";
    constexpr int kThreads = 16;  // SQLite keeps the descriptors of readers for the next ones
    wait_until([&] { return open_files(daemon_.pid()) <= files_ + kThreads; });
    EXPECT_EQ(daemon_.end_with(SIGTERM), 0);
  }

  template <class Condition>
  void wait_until(const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!condition() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    EXPECT_TRUE(condition());
  }

  std::string cases_path() const { return "/v1/studies/" + study_ + "/cases"; }

  std::string answer_to(const std::string& request) {
    RawConnection connection(daemon_.url());
    connection.send(request);
    return connection.receive_all();
  }

  /// More clients than threads send the same beginning of a request and nothing more; the server still
  /// answers.
  void hold_with(const std::string& beginning) {
    std::vector<RawConnection> held;
    for (int i = 0; i < 40; ++i) {
      held.emplace_back(daemon_.url());
      held.back().send(beginning);
    }
    EXPECT_EQ(status_of(answer_to(request_text("GET", "/healthz"))), 200);
    for (RawConnection& connection : held)
      EXPECT_THAT(status_of(connection.receive_all()), AnyOf(0, 400, 408)) << beginning.substr(0, 80);
  }

  TemporaryDirectory data_;
  Daemon daemon_{data_.path()};
  std::string study_, results_;
  double memory_mb_ = 0;
  long files_ = 0;
};

/// Far more connections than threads, all of one client. The last one is still open after another was
/// answered.
TEST_F(HostileClientTest, IdleConnectionsDelayNobody) {
  for (const char* beginning : {"", "GET /healthz HTTP/1.1\r\nHost: loc"}) {
    std::vector<RawConnection> held;
    for (int i = 0; i < 600; ++i) {
      held.emplace_back(daemon_.url());
      held.back().send(beginning);
    }
    EXPECT_EQ(status_of(answer_to(request_text("GET", "/healthz"))), 200);
    EXPECT_FALSE(held.back().closes_within(std::chrono::milliseconds(0)));
  }
}

TEST_F(HostileClientTest, ClientWithTheMostConnectionsLosesItsOldestToMakeRoomForOthers) {
  std::vector<RawConnection> held;
  for (int i = 0; i < 1100; ++i) held.emplace_back(daemon_.url());
  EXPECT_EQ(status_of(answer_to(request_text("GET", "/healthz"))), 200);
  EXPECT_TRUE(held.front().closes_within(std::chrono::seconds(1)));
}

/// Bodies of almost a mebibyte that stay incomplete.
TEST_F(HostileClientTest, IncompleteLargeBodiesTakeLittleMemory) {
  std::vector<RawConnection> held;
  for (int i = 0; i < 200; ++i) {
    held.emplace_back(daemon_.url());
    held.back().send(
        "POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
        "1048576\r\n\r\n" +
        std::string(1'000'000, ' '));
  }
  EXPECT_EQ(status_of(answer_to(request_text("GET", "/healthz"))), 200);
  EXPECT_LT(resident_mb(daemon_.pid()), memory_mb_ + 150);
  for (RawConnection& connection : held) EXPECT_THAT(status_of(connection.receive_all()), AnyOf(408, 503, 0));
}

TEST_F(HostileClientTest, SilentClientsHoldNoThreadForLong) { hold_with(""); }

TEST_F(HostileClientTest, SlowHeadsHoldNoThreadForLong) { hold_with("GET /healthz HTTP/1.1\r\nHost: loc"); }

TEST_F(HostileClientTest, SlowBodiesHoldNoThreadForLong) {
  hold_with(
      "POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
      "99\r\n\r\n{");
}

/// Further bytes do not prolong the deadline: it is the connection's.
TEST_F(HostileClientTest, DripOfBytesHoldsNoThreadForLong) {
  std::vector<RawConnection> held;
  for (int i = 0; i < 20; ++i) held.emplace_back(daemon_.url());
  for (RawConnection& connection : held) connection.send("GET /healthz HTTP/1.1\r\n");
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!held.empty() && std::chrono::steady_clock::now() < deadline)
    std::erase_if(held, [](RawConnection& connection) {
      return connection.closes_within(std::chrono::milliseconds(5)) || !connection.send("a");
    });
  EXPECT_TRUE(held.empty());
}

TEST_F(HostileClientTest, ClientsThatReadNothingHoldNoThread) {
  std::vector<RawConnection> held;
  for (int i = 0; i < 40; ++i) {
    held.emplace_back(daemon_.url());
    held.back().send(request_text("GET", cases_path()));
  }
  EXPECT_EQ(status_of(answer_to(request_text("GET", "/healthz"))), 200);
}

TEST_F(HostileClientTest, HeadOfEightMebibytesIsNotKept) {
  for (int i = 0; i < 20; ++i) {
    RawConnection line(daemon_.url()), lines(daemon_.url());
    line.send("GET / HTTP/1.1\r\nHost: localhost\r\nA: " + std::string(8 << 20, 'a') + "\r\n\r\n");
    EXPECT_THAT(status_of(line.receive_all()), AnyOf(431, 0));
    std::string many;
    for (int field = 0; field < (1 << 20); ++field) many += "A: bcde\r\n";
    lines.send("GET / HTTP/1.1\r\nHost: localhost\r\n" + many + "\r\n");
    EXPECT_THAT(status_of(lines.receive_all()), AnyOf(431, 0));
  }
}

TEST_F(HostileClientTest, ChunkedOrCompressedBombsAreRefusedUnread) {
  const std::string start =
      "POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
  RawConnection chunks(daemon_.url());
  chunks.send(start + "Transfer-Encoding: chunked\r\n\r\n");
  for (int i = 0; i < 64 && chunks.send("10000\r\n" + std::string(0x10000, ' ') + "\r\n"); ++i) {
  }
  EXPECT_THAT(status_of(chunks.receive_all()), AnyOf(411, 0));
  EXPECT_EQ(status_of(answer_to(start + "Transfer-Encoding: chunked\r\n\r\n-5\r\n{}\r\n0\r\n\r\n")), 411);
  EXPECT_EQ(status_of(answer_to(start + "Content-Encoding: gzip\r\nContent-Length: 4\r\n\r\n\x1f\x8b\x08 ")),
            415);
}

TEST_F(HostileClientTest, RequestInTheBodyOfAnotherIsNeverAnswered) {
  const std::string inner =
      request_text("POST", "/v1/studies", "", study_document("inner", {{"Ca", {1}}}).dump());
  const std::string start =
      "POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
  for (const std::string& length :
       {std::string("Content-Length: 5\r\nTransfer-Encoding: chunked\r\n"),
        std::string("Content-Length: 0\r\n"), std::string("Content-Length: 5\r\nContent-Length: 0\r\n"),
        std::string("Content-Length: -1\r\n"),
        std::string("Transfer-Encoding: chunked\r\nTransfer-Encoding: identity\r\n"), std::string()}) {
    const std::string answer = answer_to(start + length + "\r\n0\r\n\r\n" + inner);
    EXPECT_GE(status_of(answer), 400) << length;
    EXPECT_EQ(answer.find("HTTP/1.1", 1), answer.npos) << length << answer;
  }
}

TEST_F(HostileClientTest, DeepOrUnendedJsonIsRefusedWith422) {
  for (const std::string& body :
       {std::string(1'000'000, '['), std::string(1'000'000, '{'), "{\"a\":" + std::string(900'000, '['),
        "\"" + std::string(1'000'000, 'a'), std::string(1'000'000, '9'), "[" + std::string(1'000'000, ',')})
    EXPECT_EQ(status_of(answer_to(request_text("POST", "/v1/studies", "", body))), 422) << body.substr(0, 20);
}

TEST_F(HostileClientTest, ThousandClientsAtOnceAreAllAnswered) {
  constexpr int kClients = 1000;
  std::vector<RawConnection> clients;
  for (int i = 0; i < kClients; ++i) clients.emplace_back(daemon_.url());
  for (RawConnection& client : clients) client.send(request_text("GET", cases_path()));
  int answered = 0;
  for (RawConnection& client : clients) answered += client.receive_all() == results_ ? 1 : 0;
  EXPECT_EQ(answered, kClients);
}

}  // namespace
}  // namespace capstan
