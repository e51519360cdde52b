#include "runner/web/http_server.hpp"

#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "runner/results/timestamp.hpp"
#include "runner/web/routes.hpp"
#include "runner/web/target.hpp"
#include "runner/web/traffic.hpp"

namespace capstan {
namespace {

using Steady = std::chrono::steady_clock;

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
/// Without Accept-Encoding it compresses nothing, and one tag means one sequence of bytes.
void put_fields(const Head& head, httplib::Request& in) {
  in.headers.clear();
  for (const auto& [name, value] : head.fields)
    if (!equal_ignoring_case(name, "Accept-Encoding")) in.headers.emplace(name, value);
}

void put_head(const Response& response, httplib::Response& out) {
  out.status = response.status;
  out.set_header("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : response.headers) out.set_header(name, value);
}

/// More may be on its way: that of a request whose head is not known, too.
bool announces_body(const Head& head) {
  return head.method.empty() || head.content_length > 0 || head.count("Transfer-Encoding") > 0;
}

/// One daemon a port: SO_REUSEPORT, the library's default, would let a second one share it unnoticed.
void allow_quick_restart(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

HttpServer::Wakeable::Wakeable(HttpServer& server, int socket) : server_(server), socket_(socket) {
  const std::lock_guard lock(server_.reading_mutex_);
  server_.reading_.insert(socket_);
  if (server_.waiting_.is_closed()) shutdown(socket_, SHUT_RD);
}

HttpServer::Wakeable::~Wakeable() {
  const std::lock_guard lock(server_.reading_mutex_);
  server_.reading_.erase(socket_);
}

HttpServer::HttpServer(Service& service, Access access)
    : service_(service), access_(std::move(access)), log_(service.data().path() / "requests.log") {
  configure();
}

HttpServer::~HttpServer() {
  waiting_.close();
  if (svr_sock_ != INVALID_SOCKET) shutdown(svr_sock_, SHUT_RDWR);  // accept() returns
  const int listening = svr_sock_.exchange(INVALID_SOCKET);         // streams end
  {
    const std::lock_guard lock(reading_mutex_);
    for (const int socket : reading_) shutdown(socket, SHUT_RD);
  }
  for (std::thread& thread : threads_) thread.join();
  if (listening != INVALID_SOCKET) close(listening);
}

void HttpServer::configure() {
  const auto answer = [this](const httplib::Request& in, httplib::Response& out) {
    send(out, respond(service_, received_by(in)));
  };
  const std::string any_path = "/.*";
  Get(any_path, answer).Post(any_path, answer).Put(any_path, answer);
  Patch(any_path, answer).Delete(any_path, answer).Options(any_path, answer);
  set_socket_options(allow_quick_restart);
  set_payload_max_length(kLongestBody);
  // What the library finds wrong by itself, such as a body that ends in the middle.
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
  threads_.emplace_back([this] { accept_all(); });
  for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { serve_all(); });
  return port;
}

void HttpServer::accept_all() {
  const int listening = svr_sock_;
  while (!waiting_.is_closed()) {
    const int socket = accept4(listening, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket < 0) {  // no descriptor to be had, as a rule: others are given back soon
      if (errno != EINTR && errno != ECONNABORTED) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    if (!waiting_.push({socket, Steady::now()})) close(socket);
  }
}

void HttpServer::serve_all() {
  while (const auto accepted = waiting_.pop()) {
    ++traffic().connections;
    try {
      serve(*accepted);
    } catch (const std::exception& error) {
      std::clog << "capstan: a connection: " << error.what() << std::endl;
    }
    --traffic().connections;
  }
}

void HttpServer::serve(const Accepted& accepted) {
  constexpr std::chrono::milliseconds kLeast{250};  // for those that waited long for a thread
  const int yes = 1;
  setsockopt(accepted.socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  Connection connection(accepted.socket, std::max(accepted.time + kLongestReceive, Steady::now() + kLeast));
  const Wakeable wakeable(*this, accepted.socket);
  const ReceivedHead received = connection.receive_head();
  if (received.is_empty) return;
  Head head;
  if (const auto refusal = refusal_of(received, head)) {
    connection.refuse(*refusal, head.method == "HEAD");
  } else {
    pass_on(connection, received, head);
  }
  report(connection, head, accepted);
  if (connection.has_unread() || (connection.status() >= 400 && announces_body(head))) connection.absorb();
}

std::optional<Response> HttpServer::refusal_of(const ReceivedHead& received, Head& head) const {
  if (received.refusal) return received.refusal;
  ParsedHead parsed = parse_head(received.text);
  head = std::move(parsed.head);
  if (!parsed.refusal) parsed.refusal = refuse_access(access_, head);
  if (!parsed.refusal) parsed.refusal = refuse_hazards(head);
  return std::move(parsed.refusal);
}

void HttpServer::pass_on(Connection& connection, const ReceivedHead& received, const Head& head) {
  connection.allow(received.text.size(), head.content_length);
  bool is_closed = false;
  process_request(connection, true, is_closed, [&](httplib::Request& in) { put_fields(head, in); });
}

void HttpServer::send(httplib::Response& out, const Response& response) {
  if (response.next) return send_stream(out, response);
  put_head(response, out);
  out.set_content(response.body, response.content_type);
}

/// Each stream holds a thread as long as it lasts.
void HttpServer::send_stream(httplib::Response& out, const Response& response) {
  if (++traffic().streams > kMostStreams) {
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

void HttpServer::report(const Connection& connection, const Head& head, const Accepted& accepted) {
  constexpr std::size_t kLongest = 200;
  const std::chrono::duration<double, std::milli> time = Steady::now() - accepted.time;
  traffic().count(connection.status(), time);
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, " %d %zu B %.1f ms", connection.status(), connection.bytes_written(),
                time.count());
  log_.write(timestamp(SystemClock().now().time_since_epoch().count()) + " " + connection.peer() + " " +
             (head.method.empty() ? "-" : head.method) + " " +
             (head.target.empty() ? "-" : head.target.substr(0, kLongest)) + numbers);
}

}  // namespace capstan
