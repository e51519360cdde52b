#include "runner/web/server.hpp"

#include <httplib.h>

#include <stdexcept>

#include "runner/web/routes.hpp"

namespace capstan {
namespace {

constexpr std::size_t kLongestBody = 1 << 20;  // a study of 10,000 listed values has 100 kB
constexpr std::size_t kLongestPath = 1000;     // the library matches paths by recursion

void send(httplib::Response& out, const Response& response) {
  out.status = response.status;
  for (const auto& [name, value] : response.headers) out.set_header(name, value);
  out.set_content(response.body, response.content_type);
}

Request received(const httplib::Request& in) {
  Request request{in.method == "HEAD" ? "GET" : in.method, in.path, {},
                  in.get_header_value("Accept"),           in.body, in.get_header_value("Idempotency-Key"),
                  in.get_header_value("If-None-Match")};
  request.query.assign(in.params.begin(), in.params.end());
  return request;
}

/// What the library would get wrong is refused before it reads a body: it limits neither the size of a
/// chunked body nor that of one it inflates.
httplib::Server::HandlerResponse refuse_hazards(const httplib::Request& in, httplib::Response& out) {
  using Reply = httplib::Server::HandlerResponse;
  if (in.path.size() > kLongestPath)
    send(out, problem(414, "URI too long", "paths have at most 1000 characters"));
  else if (in.has_header("Transfer-Encoding"))
    send(out, problem(411, "Length required", "send the body with a Content-Length, not in chunks"));
  else if (in.has_header("Content-Encoding"))
    send(out, problem(415, "Unsupported media type", "send the body uncompressed"));
  else
    return Reply::Unhandled;
  return Reply::Handled;
}

/// Errors that the library found by itself, such as a body that is too large.
void explain_error(const httplib::Request&, httplib::Response& out) {
  if (!out.body.empty()) return;
  const bool too_large = out.status == 413;
  send(out,
       problem(out.status, too_large ? "Content too large" : "Bad request",
               too_large ? "a study has at most 1 MiB" : "this is no HTTP request that can be answered"));
}

/// One daemon a port: SO_REUSEPORT, the library's default, would let a second one share it unnoticed.
void allow_quick_restart(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void configure(httplib::Server& http, Service& service) {
  const auto answer = [&service](const httplib::Request& in, httplib::Response& out) {
    send(out, respond(service, received(in)));
  };
  const std::string any_path = "/.*";
  http.Get(any_path, answer).Post(any_path, answer).Put(any_path, answer);
  http.Patch(any_path, answer).Delete(any_path, answer).Options(any_path, answer);
  http.set_pre_routing_handler(refuse_hazards);
  http.set_error_handler(explain_error);
  http.set_socket_options(allow_quick_restart);
  http.set_payload_max_length(kLongestBody);
  http.set_keep_alive_max_count(1);  // an unread body of a refused request must not be taken for the next one
}

}  // namespace

Server::Server(Service& service, Address address)
    : address_(std::move(address)), http_(std::make_unique<httplib::Server>()) {
  configure(*http_, service);
  const bool any_port = address_.port == 0;
  const int port = any_port ? http_->bind_to_any_port(address_.host)
                            : (http_->bind_to_port(address_.host, address_.port) ? address_.port : -1);
  if (port <= 0) throw std::runtime_error("cannot listen on " + url_of(address_) + ": is it taken?");
  address_.port = port;
  thread_ = std::thread([this] { http_->listen_after_bind(); });
}

Server::~Server() {
  http_->stop();
  thread_.join();
}

}  // namespace capstan
