#pragma once
// Connections that wait for a thread: no more than a number, beyond which they wait in the kernel's backlog.
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace capstan {

struct Accepted {
  int socket;
  std::chrono::steady_clock::time_point time;  ///< waiting for a thread counts, too
};

class ConnectionQueue {
 public:
  explicit ConnectionQueue(std::size_t most) : most_(most) {}
  ~ConnectionQueue() {
    for (const Accepted& accepted : waiting_) ::close(accepted.socket);
  }

  /// Waits for room; false once the queue is closed.
  bool push(const Accepted& accepted) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || waiting_.size() < most_; });
    if (is_closed_) return false;
    waiting_.push_back(accepted);
    changed_.notify_all();
    return true;
  }

  /// Waits for a connection; nothing once the queue is closed.
  std::optional<Accepted> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || !waiting_.empty(); });
    if (is_closed_) return std::nullopt;
    const Accepted first = waiting_.front();
    waiting_.pop_front();
    changed_.notify_all();
    return first;
  }

  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

  bool is_closed() {
    const std::lock_guard lock(mutex_);
    return is_closed_;
  }

 private:
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Accepted> waiting_;
  bool is_closed_ = false;
};

}  // namespace capstan
