#pragma once
// What other threads ask of the socket loop. An eventfd wakes the loop up.
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "runner/web/connection.hpp"

namespace capstan {

struct LoopRequests {
  std::vector<int> adopted;
  std::vector<std::unique_ptr<Connection>> to_finish;
  int to_listen = -1;  ///< a listening socket, or -1
  bool should_stop_receiving = false;
  bool should_end = false;
};

class LoopMessages {
 public:
  LoopMessages();
  ~LoopMessages();
  LoopMessages(const LoopMessages&) = delete;
  LoopMessages& operator=(const LoopMessages&) = delete;

  // Called by other threads:
  void listen(int socket);
  void adopt(int socket);
  void finish(std::unique_ptr<Connection> connection);
  /// Blocks until the loop calls confirm_stopped_receiving().
  void stop_receiving();
  void end();

  // Called by the loop:
  int wake_up_descriptor() const { return wake_up_; }  ///< readable when there are messages
  LoopRequests take();                                 ///< all that have come since the last call
  void confirm_stopped_receiving();

 private:
  void wake_up();

  const int wake_up_;
  std::mutex mutex_;
  LoopRequests requests_;
  bool has_stopped_receiving_ = false;
  std::condition_variable stopped_receiving_;
};

}  // namespace capstan
