#include "runner/web/connection.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "runner/web/head.hpp"

namespace capstan {
namespace {

using std::chrono::milliseconds;
using Steady = Connection::Steady;

/// False at the deadline. A deadline that has passed is not waited for, whatever there is.
bool wait_for(int socket, short events, Steady::time_point until) {
  for (;;) {
    const auto left = std::chrono::ceil<milliseconds>(until - Steady::now()).count();
    if (left <= 0) return false;
    pollfd watched{socket, events, 0};
    if (poll(&watched, 1, static_cast<int>(left)) > 0) return true;
  }
}

bool is_to_be_tried_again(int error) { return error == EAGAIN || error == EINTR; }

std::string peer_of(int socket) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &size) != 0) return "-";
  char text[INET6_ADDRSTRLEN] = "-";
  if (peer.ss_family == AF_INET)
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in&>(peer).sin_addr, text, sizeof text);
  if (peer.ss_family == AF_INET6)
    inet_ntop(AF_INET6, &reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr, text, sizeof text);
  return text;
}

}  // namespace

Connection::Connection(int socket, Steady::time_point read_until)
    : socket_(socket), peer_(peer_of(socket)), read_until_(read_until) {}

Connection::~Connection() { close(socket_); }

ssize_t Connection::receive(char* to, std::size_t size) {
  for (;;) {
    is_late_ = !wait_for(socket_, POLLIN, read_until_);
    if (is_late_) return -1;
    const ssize_t count = recv(socket_, to, size, MSG_DONTWAIT);
    if (count >= 0 || !is_to_be_tried_again(errno)) return count;
  }
}

ReceivedHead Connection::receive_head() {
  constexpr std::string_view kEnd = "\r\n\r\n";
  char part[4096];
  while (received_.size() <= kLongestHead) {
    const ssize_t count = receive(part, sizeof part);
    if (is_late_ && received_.empty()) return {"", {}, true};
    if (is_late_) return {"", problem(408, "Request timeout", "the request did not come in time")};
    if (count <= 0 && received_.empty()) return {"", {}, true};
    if (count <= 0) return {"", problem(400, "Bad request", "the head ends in the middle")};
    const std::size_t seen = received_.size() < kEnd.size() ? 0 : received_.size() - kEnd.size() + 1;
    received_.append(part, static_cast<std::size_t>(count));
    const std::size_t end = received_.find(kEnd, seen);
    if (end != received_.npos && end + kEnd.size() <= kLongestHead)
      return {received_.substr(0, end + kEnd.size())};
  }
  return {"", problem(431, "Request header fields too large", "a head has at most 16 KiB")};
}

ssize_t Connection::read(char* to, std::size_t size) {
  size = std::min(size, left_);
  if (size == 0) return 0;
  ssize_t count = 0;
  if (position_ < received_.size()) {
    size = std::min(size, received_.size() - position_);
    std::memcpy(to, received_.data() + position_, size);
    position_ += size;
    count = static_cast<ssize_t>(size);
  } else {
    count = receive(to, size);
  }
  if (count > 0) left_ -= static_cast<std::size_t>(count);
  return count;
}

/// All of it, or -1: so that a client that reads byte by byte gains no time.
ssize_t Connection::write(const char* from, std::size_t size) {
  constexpr std::size_t kSlowest = 64 << 10;  // bytes a second
  constexpr std::string_view kStatusLine = "HTTP/1.1 ";
  if (std::string_view(from, size).starts_with(kStatusLine)) status_ = std::atoi(from + kStatusLine.size());
  const auto until = Steady::now() + milliseconds(5000 + 1000 * size / kSlowest);
  for (std::size_t sent = 0; sent < size;) {
    if (!wait_for(socket_, POLLOUT, until)) return -1;
    const ssize_t count = send(socket_, from + sent, size - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && !is_to_be_tried_again(errno)) return -1;
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
  bytes_written_ += size;
  return static_cast<ssize_t>(size);
}

bool Connection::is_writable() const {
  pollfd watched{socket_, POLLRDHUP, 0};
  return poll(&watched, 1, 0) == 0;
}

void Connection::refuse(const Response& response, bool is_head_request) {
  std::string text = "HTTP/1.1 " + std::to_string(response.status) +
                     " \r\nContent-Type: " + response.content_type +
                     "\r\nContent-Length: " + std::to_string(response.body.size()) +
                     "\r\nConnection: close\r\nX-Content-Type-Options: nosniff\r\n";
  for (const auto& [name, value] : response.headers) text += name + ": " + value + "\r\n";
  text += "\r\n" + (is_head_request ? "" : response.body);
  write(text);
}

bool Connection::has_unread() const {
  int bytes = 0;
  return ioctl(socket_, FIONREAD, &bytes) == 0 && bytes > 0;
}

void Connection::absorb() {
  constexpr milliseconds kIdle{250};
  constexpr std::size_t kMost = 16 << 20;
  shutdown(socket_, SHUT_WR);
  char part[4096];
  const auto until = std::max(read_until_, Steady::now() + kIdle);
  for (std::size_t taken = 0; taken < kMost && Steady::now() < until;) {
    if (!wait_for(socket_, POLLIN, Steady::now() + kIdle)) return;
    const ssize_t count = recv(socket_, part, sizeof part, MSG_DONTWAIT);
    if (count <= 0) return;
    taken += static_cast<std::size_t>(count);
  }
}

}  // namespace capstan
