#include "runner/web/loop_messages.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <utility>

namespace capstan {

LoopMessages::LoopMessages() : wake_up_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

LoopMessages::~LoopMessages() {
  for (const int socket : requests_.adopted) close(socket);
  close(wake_up_);
}

void LoopMessages::listen(int socket) {
  const std::lock_guard lock(mutex_);
  requests_.to_listen = socket;
  wake_up();
}

void LoopMessages::adopt(int socket) {
  const std::lock_guard lock(mutex_);
  requests_.adopted.push_back(socket);
  wake_up();
}

void LoopMessages::finish(std::unique_ptr<Connection> connection) {
  const std::lock_guard lock(mutex_);
  requests_.to_finish.push_back(std::move(connection));
  wake_up();
}

void LoopMessages::stop_receiving() {
  std::unique_lock lock(mutex_);
  requests_.should_stop_receiving = true;
  wake_up();
  stopped_receiving_.wait(lock, [&] { return has_stopped_receiving_; });
}

void LoopMessages::end() {
  const std::lock_guard lock(mutex_);
  requests_.should_end = true;
  wake_up();
}

LoopRequests LoopMessages::take() {
  const std::lock_guard lock(mutex_);
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t taken = read(wake_up_, &count, sizeof count);
  return std::exchange(requests_, LoopRequests());
}

void LoopMessages::confirm_stopped_receiving() {
  const std::lock_guard lock(mutex_);
  has_stopped_receiving_ = true;
  stopped_receiving_.notify_all();
}

void LoopMessages::wake_up() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(wake_up_, &one, sizeof one);
}

}  // namespace capstan
