#include "runner/web/http_server.hpp"

#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "runner/store/timestamp.hpp"
#include "runner/web/http_metrics.hpp"
#include "runner/web/listening_socket.hpp"
#include "runner/web/request_restrictions.hpp"
#include "runner/web/routes.hpp"
#include "runner/web/startup_response.hpp"

namespace capstan {
namespace {

/// Adds one to a gauge while it lives.
class Counted {
 public:
  explicit Counted(std::atomic<int>& gauge) : gauge_(gauge), value_(++gauge) {}
  ~Counted() { --gauge_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  int value() const { return value_; }

 private:
  std::atomic<int>& gauge_;
  const int value_;
};

Response too_many_streams() {
  Response refusal = problem(503, "Too many streams", "too many clients follow studies already");
  refusal.headers["Retry-After"] = "5";
  return refusal;
}

}  // namespace

HttpServer::HttpServer(const std::filesystem::path& data, AccessControl access)
    : data_(data),
      access_(std::move(access)),
      log_(data / "requests.log"),
      loop_(ready_, [this](const httplib::Request& request) { return refusal_of(request); }) {
  for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { serve_all(); });
}

HttpServer::~HttpServer() {
  loop_.stop_receiving();
  ready_.close();
  is_ending_ = true;
  for (std::thread& thread : threads_) thread.join();
  if (listening_ >= 0) close(listening_);
}

ListenAddress HttpServer::listen_at(ListenAddress address) {
  listening_ = open_listening_socket(address);
  address.port = port_of(listening_);
  loop_.listen(listening_);
  return address;
}

/// What each request thread does.
void HttpServer::serve_all() {
  while (std::unique_ptr<Connection> connection = ready_.pop()) {
    const Counted served(http_metrics().connections);
    try {
      answer(*connection);
      const std::size_t size = connection->bytes_written();
      loop_.finish(std::move(connection));
      freed_memory_.after_response(size);
    } catch (const std::exception& error) {
      std::clog << "capstan: a connection: " << error.what() << std::endl;
    }
  }
}

void HttpServer::answer(Connection& connection) {
  const ConnectionQueue::InService in_service(ready_, connection);
  const Response response = connection.refusal() ? *connection.refusal() : response_to(connection.request());
  if (response.next)
    send_stream(connection, response);
  else
    connection.send(response);
  record(connection);
}

Response HttpServer::response_to(const httplib::Request& request) {
  Service* const service = service_;
  return service ? respond(*service, request) : respond_while_starting(data_, request);
}

void HttpServer::send_stream(Connection& connection, const Response& response) {
  const Counted stream(http_metrics().streams);
  if (stream.value() > kMaxStreams) return connection.send(too_many_streams());
  connection.send_stream(response, [this] { return is_ending_.load(); });
}

std::optional<Response> HttpServer::refusal_of(const httplib::Request& request) const {
  auto refusal = refuse_access(access_, request);
  return refusal ? refusal : refuse_unsupported(request);
}

/// Counts the request in the metrics and writes its line of the log.
void HttpServer::record(const Connection& connection) {
  constexpr std::size_t kMaxTarget = 200;
  const httplib::Request& request = connection.request();
  const std::chrono::duration<double, std::milli> time = Connection::Steady::now() - connection.accepted();
  http_metrics().count_request(connection.status(), time);
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, " %d %zu B %.1f ms", connection.status(), connection.bytes_written(),
                time.count());
  log_.write(timestamp(SystemClock().now().time_since_epoch().count()) + " " + connection.peer() + " " +
             (request.method.empty() ? "-" : request.method) + " " +
             (request.target.empty() ? "-" : request.target.substr(0, kMaxTarget)) + numbers);
}

}  // namespace capstan
