#pragma once
// One thread that waits for all clients. It accepts connections, receives requests, sends the rest of
// responses that clients are slow to read, and closes connections. So a complete request finds a free request
// thread, however many clients are silent or slow.
//
//   accept → receiving → (queue: a request thread writes the response) → sending → lingering → closed
#include <chrono>
#include <memory>
#include <thread>

#include "runner/web/connection.hpp"
#include "runner/web/connection_queue.hpp"
#include "runner/web/loop_messages.hpp"
#include "runner/web/watched_connections.hpp"

namespace capstan {

class SocketLoop {
 public:
  /// Time limit from accepting a connection to a complete request. Later an incomplete request is refused.
  static constexpr std::chrono::seconds kMaxReceiveTime{5};
  /// Beyond it, the client with the most connections loses its oldest one whose request is incomplete.
  static constexpr std::size_t kMaxConnections = 1024;
  static constexpr std::size_t kMaxBytes = 64 << 20;  ///< of all requests and responses held in memory

  /// \param ready  receives the connections whose request is complete, or is to be refused
  SocketLoop(ConnectionQueue& ready, Connection::HeadCheck check);
  /// Gives clients one second to read their responses.
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  // From any thread:
  /// \param socket  a listening socket; the caller closes it
  void listen(int socket) { messages_.listen(socket); }
  /// Takes ownership of a connection that was accepted elsewhere.
  void adopt(int socket) { messages_.adopt(socket); }
  /// Sends the rest of a response and closes the connection.
  void finish(std::unique_ptr<Connection> connection);
  /// Stops accepting and receiving: incomplete requests are refused. Returns when the refusals are in the
  /// queue.
  void stop_receiving() { messages_.stop_receiving(); }

 private:
  using Steady = Connection::Steady;
  using Phase = WatchedConnections::Phase;
  using Iterator = WatchedConnections::Iterator;

  void run();
  void handle_event(int descriptor);
  void accept_all();
  void receive(Iterator watched);
  void send(Iterator watched);
  void linger(Iterator watched);
  void process_messages();
  void start_listening(int socket);
  void start_receiving(int socket);
  void start_finishing(std::unique_ptr<Connection> connection);
  void close_expired();
  void end_receiving();
  void refuse(Iterator watched, Response refusal);
  bool is_full();
  bool evict_one();
  bool has_ended() const;

  ConnectionQueue& ready_;
  const Connection::HeadCheck check_;
  const std::size_t max_connections_;
  Epoll epoll_;
  LoopMessages messages_;
  int listening_ = -1;
  WatchedConnections watched_{epoll_};
  Steady::time_point end_ = Steady::time_point::max();  ///< the loop ends at this time at the latest
  std::thread thread_;
};

}  // namespace capstan
