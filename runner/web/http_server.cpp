#include "runner/web/http_server.hpp"

#include <malloc.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <stdexcept>

#include "runner/store/timestamp.hpp"
#include "runner/web/routes.hpp"
#include "runner/web/starting.hpp"
#include "runner/web/target.hpp"
#include "runner/web/traffic.hpp"

namespace capstan {
namespace {

/// A header that may stand in several lines is one list.
std::string all_values(const httplib::Request& in, const std::string& name) {
  std::string list;
  const auto [first, last] = in.headers.equal_range(name);
  for (auto field = first; field != last; ++field) list += (list.empty() ? "" : ", ") + field->second;
  return list;
}

Request received_by(const httplib::Request& in) {
  const std::size_t mark = std::min(in.target.find('?'), in.target.size());
  Request request{in.method == "HEAD" ? "GET" : in.method,
                  in.target.substr(0, mark),
                  {},
                  all_values(in, "Accept"),
                  in.body};
  if (mark < in.target.size()) request.query = read_query(std::string_view(in.target).substr(mark + 1));
  request.idempotency_key = in.get_header_value("Idempotency-Key");
  request.if_none_match = in.get_header_value("If-None-Match");
  request.last_event_id = in.get_header_value("Last-Event-ID");
  return request;
}

/// The library decodes %-escapes in header values and adds fields of its own: it is given what was checked.
/// Without Accept-Encoding it compresses nothing, and one tag means one sequence of bytes. Expect was
/// answered.
void put_fields(const Head& head, httplib::Request& in) {
  in.headers.clear();
  for (const auto& [name, value] : head.fields)
    if (!equal_ignoring_case(name, "Accept-Encoding") && !equal_ignoring_case(name, "Expect"))
      in.headers.emplace(name, value);
}

void put_head(const Response& response, httplib::Response& out) {
  out.status = response.status;
  out.set_header("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : response.headers) out.set_header(name, value);
}

/// One daemon a port: SO_REUSEPORT, the library's default, would let a second one share it unnoticed.
void allow_quick_restart(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

/// What a large answer took goes back to the system: sixteen threads would keep a share each. After every
/// answer that would take a third of the time.
void give_back_large(std::size_t answer_bytes) {
  constexpr std::size_t kLarge = 256 << 10;
  static std::mutex trimming;
  if (answer_bytes < kLarge) return;
  if (const std::unique_lock lock(trimming, std::try_to_lock); lock) malloc_trim(0);
}

}  // namespace

HttpServer::HttpServer(const std::filesystem::path& data, Access access)
    : data_(data),
      access_(std::move(access)),
      log_(data / "requests.log"),
      loop_(complete_, [this](const Head& head) { return refusal_of(head); }) {
  configure();
  for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { serve_all(); });
}

HttpServer::~HttpServer() {
  loop_.stop_receiving();
  complete_.close();
  const int listening = svr_sock_.exchange(INVALID_SOCKET);  // streams end
  for (std::thread& thread : threads_) thread.join();
  if (listening != INVALID_SOCKET) close(listening);
}

void HttpServer::configure() {
  const auto answer = [this](const httplib::Request& in, httplib::Response& out) {
    Service* const service = service_;
    send(out, service ? respond(*service, received_by(in)) : respond_while_starting(data_, received_by(in)));
  };
  const std::string any_path = "/.*";
  Get(any_path, answer).Post(any_path, answer).Put(any_path, answer);
  Patch(any_path, answer).Delete(any_path, answer).Options(any_path, answer);
  set_socket_options(allow_quick_restart);
  set_payload_max_length(kMaxBody);
  // What the library finds wrong by itself.
  set_error_handler([this](const httplib::Request&, httplib::Response& out) {
    if (out.body.empty())
      send(out, problem(out.status, "Bad request", "this is no request that can be answered"));
  });
  set_exception_handler([this](const httplib::Request&, httplib::Response& out, std::exception_ptr) {
    send(out, problem(500, "Internal error", "the server could not answer"));
  });
}

int HttpServer::listen_at(const Address& address) {
  const int port = address.port == 0 ? bind_to_any_port(address.host)
                                     : (bind_to_port(address.host, address.port) ? address.port : -1);
  constexpr int kBacklog = 1024;  // the library's 5 would refuse a crowd
  if (port <= 0 || ::listen(svr_sock_, kBacklog) != 0)
    throw std::runtime_error("cannot listen on " + url_of(address) + ": is it taken?");
  loop_.listen(svr_sock_);
  return port;
}

/// A small answer may have taken much: a phase diagram is made of all cases of its study.
void HttpServer::give_back_memory() {
  constexpr std::chrono::milliseconds kMoment{250};
  const auto now = Connection::Steady::now();
  if (now < given_back_ + kMoment || !has_answered_.exchange(false)) return;
  malloc_trim(0);
  given_back_ = now;
}

void HttpServer::serve_all() {
  while (std::unique_ptr<Connection> connection = complete_.pop()) {
    ++traffic().connections;
    try {
      answer(*connection);
      const std::size_t size = connection->bytes_written();
      loop_.finish(std::move(connection));
      has_answered_ = true;
      give_back_large(size);
    } catch (const std::exception& error) {
      std::clog << "capstan: a connection: " << error.what() << std::endl;
    }
    --traffic().connections;
  }
}

void HttpServer::answer(Connection& connection) {
  const struct AtItsEnd {
    ConnectionQueue& queue;
    Connection& connection;
    ~AtItsEnd() { queue.was_answered(connection); }
  } at_its_end{complete_, connection};
  serve(connection);
  report(connection);
}

void HttpServer::serve(Connection& connection) {
  if (connection.refusal()) return connection.answer(*connection.refusal());
  bool is_closed = false;
  process_request(connection, true, is_closed,
                  [&](httplib::Request& in) { put_fields(connection.head(), in); });
}

std::optional<Response> HttpServer::refusal_of(const Head& head) const {
  auto refusal = refuse_access(access_, head);
  return refusal ? refusal : refuse_hazards(head);
}

void HttpServer::send(httplib::Response& out, const Response& response) {
  if (response.next) return send_stream(out, response);
  put_head(response, out);
  out.set_content(response.body, response.content_type);
}

/// Each stream holds a thread as long as it lasts.
void HttpServer::send_stream(httplib::Response& out, const Response& response) {
  if (++traffic().streams > kMaxStreams) {
    --traffic().streams;
    Response refusal = problem(503, "Too many streams", "too many clients follow studies already");
    refusal.headers["Retry-After"] = "5";
    return send(out, refusal);
  }
  put_head(response, out);
  out.set_content_provider(
      response.content_type,
      [next = response.next](std::size_t, httplib::DataSink& sink) {
        const std::optional<std::string> part = sink.is_writable() ? next() : std::nullopt;
        if (!part) sink.done();
        return !part || sink.write(part->data(), part->size());
      },
      [](bool) { --traffic().streams; });
}

void HttpServer::report(const Connection& connection) {
  constexpr std::size_t kMax = 200;
  const Head& head = connection.head();
  const std::chrono::duration<double, std::milli> time = Connection::Steady::now() - connection.accepted();
  traffic().count(connection.status(), time);
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, " %d %zu B %.1f ms", connection.status(), connection.bytes_written(),
                time.count());
  log_.write(timestamp(SystemClock().now().time_since_epoch().count()) + " " + connection.peer() + " " +
             (head.method.empty() ? "-" : head.method) + " " +
             (head.target.empty() ? "-" : head.target.substr(0, kMax)) + numbers);
}

}  // namespace capstan
