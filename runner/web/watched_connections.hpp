#pragma once
// The connections that the socket loop waits for, each in one phase and with a deadline.
#include <cstddef>
#include <map>
#include <memory>

#include "runner/web/connection.hpp"
#include "runner/web/epoll.hpp"

namespace capstan {

class WatchedConnections {
 public:
  using Steady = Connection::Steady;
  enum class Phase { receiving, sending, lingering };
  struct Watched {
    std::unique_ptr<Connection> connection;
    Phase phase;
    Steady::time_point deadline;
    std::size_t bytes;  ///< counted in bytes()
  };
  using Iterator = std::map<int, Watched>::iterator;

  explicit WatchedConnections(Epoll& epoll) : epoll_(epoll) {}

  void add(std::unique_ptr<Connection> connection, Phase phase, Steady::time_point deadline);
  void change(Iterator watched, Phase phase, Steady::time_point deadline);
  std::unique_ptr<Connection> remove(Iterator watched);
  /// To be called after a connection has received or sent: counts its bytes anew.
  void update_bytes(Iterator watched);

  Iterator find(int descriptor) { return by_descriptor_.find(descriptor); }
  Iterator begin() { return by_descriptor_.begin(); }
  Iterator end() { return by_descriptor_.end(); }
  std::size_t size() const { return by_descriptor_.size(); }
  /// Bytes of all requests and responses that are held in memory.
  std::size_t bytes() const { return bytes_; }

  /// Whom to evict: of the client with the most connections in that phase, the oldest one; end() if there is
  /// none.
  Iterator eviction_candidate(Phase phase);

 private:
  Epoll& epoll_;
  std::map<int, Watched> by_descriptor_;
  std::size_t bytes_ = 0;
};

}  // namespace capstan
