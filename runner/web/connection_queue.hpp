#pragma once
// Connections whose request is complete and waits for a request thread.
#include <algorithm>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "runner/web/connection.hpp"

namespace capstan {

class ConnectionQueue {
 public:
  /// Max number of requests with a body that are answered at the same time: a large study takes a second, and
  /// the other threads stay free for short requests.
  static constexpr int kMaxBodies = 6;

  void push(std::unique_ptr<Connection> connection) {
    const std::lock_guard lock(mutex_);
    bytes_ += connection->bytes_held();
    waiting_.push_back(std::move(connection));
    changed_.notify_one();
  }

  /// Waits for a connection that may be answered now. Returns nothing once the queue is closed and empty.
  std::unique_ptr<Connection> pop() {
    std::unique_lock lock(mutex_);
    Waiting::iterator next;
    changed_.wait(lock, [&] {
      next = first_allowed();
      return next != waiting_.end() || (is_closed_ && waiting_.empty());
    });
    if (next == waiting_.end()) return nullptr;
    std::unique_ptr<Connection> first = std::move(*next);
    waiting_.erase(next);
    bytes_ -= first->bytes_held();
    if (first->has_body()) ++bodies_;
    return first;
  }

  /// To be called for each connection that pop() returned, once it is answered.
  void was_answered(const Connection& connection) {
    const std::lock_guard lock(mutex_);
    if (connection.has_body()) --bodies_;
    changed_.notify_all();
  }

  /// Calls was_answered() when it goes out of scope.
  class InService {
   public:
    InService(ConnectionQueue& queue, const Connection& connection)
        : queue_(queue), connection_(connection) {}
    ~InService() { queue_.was_answered(connection_); }
    InService(const InService&) = delete;
    InService& operator=(const InService&) = delete;

   private:
    ConnectionQueue& queue_;
    const Connection& connection_;
  };

  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

  std::size_t size() {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
  }

  /// Memory of the waiting requests.
  std::size_t bytes() {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }

 private:
  using Waiting = std::deque<std::unique_ptr<Connection>>;

  Waiting::iterator first_allowed() {
    return std::find_if(waiting_.begin(), waiting_.end(),
                        [&](const auto& each) { return bodies_ < kMaxBodies || !each->has_body(); });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Waiting waiting_;
  int bodies_ = 0;  ///< requests with a body that are being answered
  std::size_t bytes_ = 0;
  bool is_closed_ = false;
};

}  // namespace capstan
