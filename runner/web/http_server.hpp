#pragma once
// The library's server behind a door of our own: it accepts, reads heads and bounds time and size itself, and
// gives the library only what it reads safely.
#include <httplib.h>

#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "runner/service/service.hpp"
#include "runner/web/access.hpp"
#include "runner/web/address.hpp"
#include "runner/web/connection.hpp"
#include "runner/web/connection_queue.hpp"
#include "runner/web/request_log.hpp"

namespace capstan {

class HttpServer : private httplib::Server {
 public:
  static constexpr int kThreads = 16;
  static constexpr int kMostStreams = kThreads / 2;  ///< the others stay free for short answers
  static constexpr int kMostWaiting = 512;           ///< descriptors: 1024 are what a process has as a rule
  static constexpr std::chrono::seconds kLongestReceive{5};

  HttpServer(Service& service, Access access);
  ~HttpServer() override;

  /// Listens from now on; the port. Throws std::runtime_error when the address is taken.
  int listen_at(const Address& address);

  /// Answers one request and closes the connection.
  void serve(const Accepted& accepted);

 private:
  /// A socket that a thread waits for; at the server's end nothing more comes from it.
  class Wakeable {
   public:
    Wakeable(HttpServer& server, int socket);
    ~Wakeable();

   private:
    HttpServer& server_;
    int socket_;
  };

  void configure();
  void accept_all();
  void serve_all();
  std::optional<Response> refusal_of(const ReceivedHead& received, Head& head) const;
  void pass_on(Connection& connection, const ReceivedHead& received, const Head& head);
  void send(httplib::Response& out, const Response& response);
  void send_stream(httplib::Response& out, const Response& response);
  void report(const Connection& connection, const Head& head, const Accepted& accepted);

  Service& service_;
  const Access access_;
  RequestLog log_;
  ConnectionQueue waiting_{kMostWaiting};
  std::mutex reading_mutex_;
  std::set<int> reading_;
  std::vector<std::thread> threads_;
};

}  // namespace capstan
