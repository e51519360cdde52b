#include "runner/web/connection.hpp"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace capstan {
namespace {

using std::chrono::milliseconds;

bool is_to_be_tried_again(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

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

/// More may be on its way: that of a request whose head is not known, too.
bool announces_body(const Head& head) {
  return head.method.empty() || head.content_length > 0 || head.count("Transfer-Encoding") > 0;
}

}  // namespace

Connection::Connection(int socket) : socket_(socket), peer_(peer_of(socket)) {
  const int yes = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

Connection::~Connection() { close(socket_); }

Connection::Input Connection::take_in(const Judge& judge) {
  char part[16 << 10];
  for (;;) {
    const ssize_t count = recv(socket_, part, sizeof part, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && is_to_be_tried_again(errno)) return Input::incomplete;
    if (count < 0 || (count == 0 && received_.empty())) return Input::ended;
    if (count == 0) {
      refuse_with(problem(400, "Bad request",
                          head_size_ > 0 ? "the body ends in the middle" : "the head ends in the middle"));
      return Input::complete;
    }
    received_.append(part, static_cast<std::size_t>(count));
    if (is_complete(judge)) return Input::complete;
  }
}

void Connection::refuse_with(Response refusal) {
  refusal_ = std::move(refusal);
  std::string().swap(received_);  // to assign an empty one would keep the memory
}

bool Connection::is_complete(const Judge& judge) {
  if (head_size_ == 0 && !read_head(judge)) return refusal_.has_value();
  return refusal_ || received_.size() >= request_size();
}

/// False while the head is incomplete or too long.
bool Connection::read_head(const Judge& judge) {
  constexpr std::string_view kEnd = "\r\n\r\n";
  const std::size_t end = received_.find(kEnd);
  if (end == received_.npos || end + kEnd.size() > kMaxHead) {
    if (received_.size() > kMaxHead)
      refuse_with(problem(431, "Request header fields too large", "a head has at most 16 KiB"));
    return false;
  }
  head_size_ = end + kEnd.size();
  ParsedHead parsed = parse_head(std::string_view(received_).substr(0, head_size_));
  head_ = std::move(parsed.head);
  refusal_ = parsed.refusal ? std::move(parsed.refusal) : judge(head_);
  if (refusal_ || received_.size() >= request_size()) return true;
  received_.reserve(request_size());
  if (head_.count("Expect") > 0) write("HTTP/1.1 100 Continue\r\n\r\n");
  return true;
}

ssize_t Connection::read(char* to, std::size_t size) {
  size = std::min(size, request_size() - position_);
  std::memcpy(to, received_.data() + position_, size);
  position_ += size;
  return static_cast<ssize_t>(size);
}

/// What the client does not take at once is kept.
ssize_t Connection::write(const char* from, std::size_t size) {
  constexpr std::string_view kStatusLine = "HTTP/1.1 ";
  if (std::string_view(from, size).starts_with(kStatusLine)) status_ = std::atoi(from + kStatusLine.size());
  if (!send_unsent()) return -1;
  bytes_written_ += size;
  std::size_t sent = 0;
  while (unsent() == 0 && sent < size) {
    const ssize_t count = send(socket_, from + sent, size - sent, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) break;
    sent += static_cast<std::size_t>(count);
  }
  if (sent < size && unsent() == 0) stuck_since_ = Steady::now();
  unsent_.append(from + sent, size - sent);
  return static_cast<ssize_t>(size);
}

bool Connection::send_unsent() const {
  while (unsent() > 0 && !is_gone_) {
    const ssize_t count = send(socket_, unsent_.data() + sent_, unsent(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && is_to_be_tried_again(errno)) return true;
    if (count < 0) is_gone_ = true;
    if (count > 0) sent_ += static_cast<std::size_t>(count);
  }
  std::string().swap(unsent_);
  sent_ = 0;
  return !is_gone_;
}

Connection::Steady::time_point Connection::send_until() const {
  constexpr std::size_t kSlowest = 64 << 10;  // bytes a second
  return stuck_since_ + milliseconds(5000 + 1000 * unsent_.size() / kSlowest);
}

/// Asked before each part of a stream.
bool Connection::is_writable() const {
  if (!send_unsent() || (unsent() > 0 && Steady::now() > send_until())) return false;
  pollfd watched{socket_, POLLRDHUP, 0};
  return poll(&watched, 1, 0) == 0;
}

void Connection::answer(const Response& response) {
  std::string text = "HTTP/1.1 " + std::to_string(response.status) +
                     " \r\nContent-Type: " + response.content_type +
                     "\r\nContent-Length: " + std::to_string(response.body.size()) +
                     "\r\nConnection: close\r\nX-Content-Type-Options: nosniff\r\n";
  for (const auto& [name, value] : response.headers) text += name + ": " + value + "\r\n";
  text += "\r\n" + (head_.method == "HEAD" ? "" : response.body);
  write(text);
}

void Connection::end_sending() { shutdown(socket_, SHUT_WR); }

bool Connection::has_unread() const {
  int bytes = 0;
  const bool has_come = ioctl(socket_, FIONREAD, &bytes) == 0 && bytes > 0;
  return has_come || (status_ >= 400 && announces_body(head_));
}

bool Connection::absorb() {
  constexpr std::size_t kMax = 16 << 20;
  char part[16 << 10];
  while (lingered_bytes_ < kMax) {
    const ssize_t count = recv(socket_, part, sizeof part, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 && is_to_be_tried_again(errno);
    lingered_bytes_ += static_cast<std::size_t>(count);
  }
  return false;
}

}  // namespace capstan
