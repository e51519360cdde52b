#pragma once
// Connections whose request is complete and waits for a thread.
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "runner/web/connection.hpp"

namespace capstan {

class ConnectionQueue {
 public:
  void push(std::unique_ptr<Connection> connection) {
    const std::lock_guard lock(mutex_);
    bytes_ += connection->bytes_held();
    waiting_.push_back(std::move(connection));
    changed_.notify_one();
  }

  /// Waits for a connection; nothing once the queue is closed and empty.
  std::unique_ptr<Connection> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return nullptr;
    std::unique_ptr<Connection> first = std::move(waiting_.front());
    waiting_.pop_front();
    bytes_ -= first->bytes_held();
    return first;
  }

  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

  std::size_t size() {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
  }

  /// Of their requests.
  std::size_t bytes() {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::unique_ptr<Connection>> waiting_;
  std::size_t bytes_ = 0;
  bool is_closed_ = false;
};

}  // namespace capstan
