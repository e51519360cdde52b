#pragma once
// The library's server behind a door of our own: it accepts, reads whole requests and bounds time and size
// itself, and gives the library only what it reads safely.
#include <httplib.h>

#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include "runner/daemon/service.hpp"
#include "runner/web/access.hpp"
#include "runner/web/address.hpp"
#include "runner/web/connection.hpp"
#include "runner/web/connection_queue.hpp"
#include "runner/web/request_log.hpp"
#include "runner/web/socket_loop.hpp"

namespace capstan {

class HttpServer : private httplib::Server {
 public:
  static constexpr int kThreads = 16;
  static constexpr int kMaxStreams = kThreads / 2;  ///< the others stay free for short answers

  /// \param data  the data directory
  HttpServer(const std::filesystem::path& data, Access access);
  ~HttpServer() override;

  /// Listens from now on; the port. Throws std::runtime_error when the address is taken.
  int listen_at(const Address& address);

  /// Until then all requests are told that the server is starting.
  void set_service(Service& service) { service_ = &service; }

  /// Answers the request of a connection that somebody else has accepted.
  void adopt(int socket) { loop_.adopt(socket); }
  void reopen_log() { log_.reopen(); }
  void give_back_memory();  ///< called by one thread

 private:
  void configure();
  void serve_all();
  void answer(Connection& connection);
  void serve(Connection& connection);
  std::optional<Response> refusal_of(const Head& head) const;
  void send(httplib::Response& out, const Response& response);
  void send_stream(httplib::Response& out, const Response& response);
  void report(const Connection& connection);

  const std::filesystem::path data_;
  std::atomic<Service*> service_ = nullptr;
  const Access access_;
  RequestLog log_;
  ConnectionQueue complete_;
  SocketLoop loop_;
  std::vector<std::thread> threads_;
  std::atomic<bool> has_answered_ = false;  ///< since the memory was given back
  Connection::Steady::time_point given_back_;
};

}  // namespace capstan
