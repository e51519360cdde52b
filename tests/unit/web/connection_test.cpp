#include "runner/web/connection.hpp"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <vector>

#include "runner/web/connection_queue.hpp"
#include "tests/support/raw_connection.hpp"

namespace capstan {
namespace {

class ConnectionTest : public ::testing::Test {
 protected:
  ConnectionTest() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) std::abort();
    client_ = ends[0];
    server_ = std::make_unique<Connection>(ends[1]);
  }
  ~ConnectionTest() override { close(client_); }

  Connection::Input send(std::string_view bytes) {
    EXPECT_EQ(::send(client_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    return server_->receive([](const httplib::Request&) { return std::nullopt; });
  }
  std::size_t receive() {
    char part[1 << 16];
    std::size_t all = 0;
    for (ssize_t count; (count = recv(client_, part, sizeof part, 0)) > 0;)
      all += static_cast<std::size_t>(count);
    return all;
  }

  int client_;
  std::unique_ptr<Connection> server_;
};

TEST_F(ConnectionTest, RequestIsCompleteWithItsLastByte) {
  using Input = Connection::Input;
  const std::string request = request_text("POST", "/v1/studies", "", "{\"a\": 1}");
  for (std::size_t i = 0; i + 1 < request.size(); ++i)
    EXPECT_EQ(send(std::string_view(request).substr(i, 1)), Input::incomplete) << i;
  EXPECT_EQ(send(std::string_view(request).substr(request.size() - 1)), Input::complete);
  EXPECT_FALSE(server_->refusal());
  EXPECT_EQ(server_->request().target, "/v1/studies");
  EXPECT_EQ(server_->request().body, "{\"a\": 1}");
}

TEST_F(ConnectionTest, RequestThatEndsInTheMiddleIsRefused) {
  send("POST /v1/studies HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\n{");
  shutdown(client_, SHUT_WR);
  EXPECT_EQ(server_->receive([](const httplib::Request&) { return std::nullopt; }),
            Connection::Input::complete);
  EXPECT_EQ(server_->refusal()->status, 400);
}

TEST_F(ConnectionTest, LongResponseIsKeptForASlowClientWithoutBlocking) {
  const Response response = csv_response(std::string(10 << 20, 'a'));
  server_->send(response);
  EXPECT_GT(server_->unsent(), 0u);
  std::size_t received = 0;
  while (server_->unsent() > 0) {
    received += receive();
    EXPECT_TRUE(server_->send_unsent());
  }
  EXPECT_EQ(received + receive(), response_head(response).size() + response.body.size());
}

TEST_F(ConnectionTest, NothingIsKeptForAClientThatHasClosed) {
  server_->send(csv_response(std::string(10 << 20, 'a')));
  close(client_);
  EXPECT_FALSE(server_->send_unsent());
  EXPECT_EQ(server_->unsent(), 0u);
  client_ = dup(0);
}

/// A connection whose request is complete.
std::unique_ptr<Connection> complete(const std::string& request) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) std::abort();
  auto connection = std::make_unique<Connection>(ends[1]);
  EXPECT_EQ(::send(ends[0], request.data(), request.size(), 0), static_cast<ssize_t>(request.size()));
  EXPECT_EQ(connection->receive([](const httplib::Request&) { return std::nullopt; }),
            Connection::Input::complete);
  close(ends[0]);
  return connection;
}

TEST(ConnectionQueue, ShortRequestsOvertakeStudiesWhileManyAreAnswered) {
  const std::string study = request_text("POST", "/v1/studies", "", "{\"a\": 1}");
  ConnectionQueue queue;
  std::vector<std::unique_ptr<Connection>> under_way;
  for (int i = 0; i <= ConnectionQueue::kMaxBodies; ++i) queue.push(complete(study));
  queue.push(complete(request_text("GET", "/healthz")));
  for (int i = 0; i < ConnectionQueue::kMaxBodies; ++i) under_way.push_back(queue.pop());
  for (const auto& each : under_way) EXPECT_EQ(each->request().method, "POST");
  EXPECT_EQ(queue.pop()->request().method, "GET");
  queue.was_answered(*under_way.back());
  EXPECT_EQ(queue.pop()->request().method, "POST");
  EXPECT_EQ(queue.size(), 0u);
}

}  // namespace
}  // namespace capstan
