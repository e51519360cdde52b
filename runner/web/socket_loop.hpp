#pragma once
// One thread that waits for all clients: it accepts, takes requests in, sends what clients are slow to take,
// and closes. However many clients are silent or slow, a request that is complete finds a thread.
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "runner/web/connection.hpp"
#include "runner/web/connection_queue.hpp"

namespace capstan {

class SocketLoop {
 public:
  /// A request that is not complete by then is refused.
  static constexpr std::chrono::seconds kMaxReceive{5};
  /// Beyond, the client with the most connections loses the oldest of those whose request is incomplete.
  static constexpr std::size_t kMaxConnections = 1024;
  static constexpr std::size_t kMaxBytes = 64 << 20;  ///< of requests and answers that are under way

  /// Complete requests, and those to be refused, go to the queue.
  SocketLoop(ConnectionQueue& complete, Connection::Judge judge);
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  // From any thread:
  /// \param listening  stays the caller's
  void listen(int listening);
  /// Takes over a connection that somebody else has accepted.
  void adopt(int socket);
  /// Sends the rest of an answer, and closes.
  void finish(std::unique_ptr<Connection> connection);
  /// Accepts and receives nothing more: requests that have begun are refused. On return they are in the
  /// queue.
  void stop_receiving();

 private:
  using Steady = Connection::Steady;
  enum class Phase { receiving, sending, lingering };
  struct Watched {
    std::unique_ptr<Connection> connection;
    Phase phase;
    Steady::time_point until;
  };
  using Place = std::map<int, Watched>::iterator;

  void run();
  bool has_ended();
  void take_messages();
  void accept_all();
  void watch(std::unique_ptr<Connection> connection, Phase phase, Steady::time_point until);
  std::unique_ptr<Connection> take(Place place);
  void look_at(int descriptor);
  void receive(Place place);
  void send(Place place);
  void linger(Place place);
  void end_late();
  void end_receiving();
  void refuse(Place place, Response refusal);
  Place victim(Phase phase);
  bool make_room();
  bool is_full();

  ConnectionQueue& complete_;
  const Connection::Judge judge_;
  const std::size_t most_;
  const int epoll_, wake_;
  int listening_ = -1;
  std::map<int, Watched> watched_;  ///< by descriptor
  std::size_t bytes_held_ = 0;

  std::mutex mutex_;  ///< guards what follows: messages from other threads
  std::vector<int> adopted_;
  std::vector<std::unique_ptr<Connection>> to_finish_;
  int to_listen_ = -1;
  bool is_stopped_ = false, has_stopped_ = false, is_ending_ = false;
  std::condition_variable stopped_;

  Steady::time_point end_ = Steady::time_point::max();
  std::thread thread_;
};

}  // namespace capstan
