#pragma once
// The HTTP server: threads that answer complete requests.
//
// cpp-httplib supplies the types of every route (Request, Headers, Params) and the client (cli/client.hpp).
// Its httplib::Server is not used: as documented it gives each connection a thread and waits for the client
// in it, and it limits neither the time of a request nor the size of a header line or of a chunked body
// (0.11.4). In its place stand
// clang-format off
//
//   socket_loop           one thread that accepts, receives, sends what clients are slow to read, and closes
//   request_head          a strict parser that fills an httplib::Request
//   request_restrictions  refuses what is not supported, before the body is read; so does access_control
//   http_server           sixteen threads that answer complete requests
//   routes                method and path → handler → Response
//   response_head         status line and header lines, in response.hpp; the connection sends them with the body
//
// clang-format on
#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include "runner/daemon/service.hpp"
#include "runner/web/access_control.hpp"
#include "runner/web/connection.hpp"
#include "runner/web/connection_queue.hpp"
#include "runner/web/freed_memory.hpp"
#include "runner/web/listen_address.hpp"
#include "runner/web/request_log.hpp"
#include "runner/web/socket_loop.hpp"

namespace capstan {

class HttpServer {
 public:
  static constexpr int kThreads = 16;
  static constexpr int kMaxStreams = kThreads / 2;  ///< each occupies a thread; the others stay free

  /// \param data  the data directory
  HttpServer(const std::filesystem::path& data, AccessControl access);
  /// Incomplete requests are refused, streams end, and all complete requests are answered.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Listens from now on. Returns the address with the port that was taken. Throws std::runtime_error if the
  /// address is taken or does not exist.
  ListenAddress listen_at(ListenAddress address);

  /// Before this call, requests are answered with "the server is starting" (startup_response.hpp).
  void set_service(Service& service) { service_ = &service; }

  /// Serves a connection that was accepted elsewhere. Takes ownership of the socket.
  void adopt(int socket) { loop_.adopt(socket); }

  /// Continues the request log in a new file, after the old one was moved away.
  void reopen_log() { log_.reopen(); }

  /// Returns freed memory to the system. To be called repeatedly by one thread.
  void trim_memory() { freed_memory_.trim(); }

 private:
  void serve_all();
  void answer(Connection& connection);
  Response response_to(const httplib::Request& request);
  void send_stream(Connection& connection, const Response& response);
  std::optional<Response> refusal_of(const httplib::Request& request) const;
  void record(const Connection& connection);

  const std::filesystem::path data_;
  const AccessControl access_;
  std::atomic<Service*> service_ = nullptr;
  RequestLog log_;
  FreedMemory freed_memory_;
  ConnectionQueue ready_;
  SocketLoop loop_;
  int listening_ = -1;
  std::atomic<bool> is_ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace capstan
