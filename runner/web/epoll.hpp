#pragma once
// Waits for events of many descriptors at once (epoll(7), level-triggered).
#include <sys/epoll.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <span>

namespace capstan {

class Epoll {
 public:
  Epoll() : descriptor_(epoll_create1(EPOLL_CLOEXEC)) {}
  ~Epoll() { close(descriptor_); }
  Epoll(const Epoll&) = delete;
  Epoll& operator=(const Epoll&) = delete;

  /// \param events  EPOLLIN, EPOLLOUT or 0
  void add(int descriptor, std::uint32_t events) { control(EPOLL_CTL_ADD, descriptor, events); }
  void change(int descriptor, std::uint32_t events) { control(EPOLL_CTL_MOD, descriptor, events); }
  void remove(int descriptor) { control(EPOLL_CTL_DEL, descriptor, 0); }

  /// The events that have come, each with its descriptor in `data.fd`; valid until the next call.
  /// \param timeout  milliseconds; -1: waits without limit
  std::span<const epoll_event> wait(int timeout) {
    const int count = epoll_wait(descriptor_, events_.data(), static_cast<int>(events_.size()), timeout);
    return {events_.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
  }

 private:
  void control(int operation, int descriptor, std::uint32_t events) {
    epoll_event wanted{};
    wanted.events = events;
    wanted.data.fd = descriptor;
    epoll_ctl(descriptor_, operation, descriptor, &wanted);
  }

  const int descriptor_;
  std::array<epoll_event, 64> events_{};
};

}  // namespace capstan
