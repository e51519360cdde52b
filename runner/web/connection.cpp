#include "runner/web/connection.hpp"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "runner/web/request_head.hpp"

namespace capstan {
namespace {

using std::chrono::milliseconds;

bool would_block(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

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

/// A request whose head could not be parsed may have a body too.
bool may_have_body(const httplib::Request& request) {
  return request.method.empty() || content_length(request) > 0 || request.has_header("Transfer-Encoding");
}

}  // namespace

Connection::Connection(int socket) : socket_(socket), peer_(peer_of(socket)) {
  const int yes = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

Connection::~Connection() { close(socket_); }

Connection::Input Connection::receive(const HeadCheck& check) {
  char part[16 << 10];
  for (;;) {
    const ssize_t count = recv(socket_, part, sizeof part, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && would_block(errno)) return Input::incomplete;
    if (count < 0 || (count == 0 && !has_begun())) return Input::closed;
    if (count == 0) {
      refuse_with(problem(400, "Bad request",
                          has_head_ ? "the body ends in the middle" : "the head ends in the middle"));
      return Input::complete;
    }
    received_.append(part, static_cast<std::size_t>(count));
    if (is_complete(check)) return Input::complete;
  }
}

void Connection::refuse_with(Response refusal) {
  refusal_ = std::move(refusal);
  std::string().swap(received_);  // assigning an empty string would keep the memory
}

/// Bytes after the body are ignored: a connection carries one request.
bool Connection::is_complete(const HeadCheck& check) {
  if (!has_head_ && !parse_received_head(check)) return refusal_.has_value();
  if (refusal_) return true;
  if (received_.size() < content_length_) return false;
  received_.resize(content_length_);
  request_.body = std::move(received_);
  received_.clear();
  return true;
}

/// False while the head is incomplete, or if it is too long.
bool Connection::parse_received_head(const HeadCheck& check) {
  constexpr std::string_view kEnd = "\r\n\r\n";
  const std::size_t end = received_.find(kEnd);
  if (end == received_.npos || end + kEnd.size() > kMaxHead) {
    if (received_.size() > kMaxHead)
      refuse_with(problem(431, "Request header fields too large", "a head has at most 16 KiB"));
    return false;
  }
  has_head_ = true;
  ParsedHead parsed = parse_head(std::string_view(received_).substr(0, end + kEnd.size()));
  received_.erase(0, end + kEnd.size());
  request_ = std::move(parsed.request);
  if (auto refusal = parsed.refusal ? std::move(parsed.refusal) : check(request_)) {
    refuse_with(std::move(*refusal));
    return true;
  }
  content_length_ = content_length(request_);
  received_.reserve(content_length_);
  if (received_.size() < content_length_ && request_.has_header("Expect"))
    write("HTTP/1.1 100 Continue\r\n\r\n");
  return true;
}

void Connection::send(const Response& response) {
  status_ = response.status;
  if (write(response_head(response)) && request_.method != "HEAD") write(response.body);
}

void Connection::send_stream(const Response& response, const std::function<bool()>& should_end) {
  send(response);
  if (request_.method == "HEAD") return;
  while (!should_end() && accepts_more()) {
    const std::optional<std::string> part = response.next();
    if (!part || !write(*part)) return;
  }
}

/// Keeps what the client does not accept at once. False if the connection is broken.
bool Connection::write(std::string_view bytes) {
  if (!send_unsent()) return false;
  bytes_written_ += bytes.size();
  while (unsent() == 0 && !bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) break;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  if (!bytes.empty() && unsent() == 0) unsent_since_ = Steady::now();
  unsent_.append(bytes);
  return true;
}

bool Connection::send_unsent() {
  while (unsent() > 0 && !is_broken_) {
    const ssize_t count = ::send(socket_, unsent_.data() + sent_, unsent(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && would_block(errno)) return true;
    if (count < 0) is_broken_ = true;
    if (count > 0) sent_ += static_cast<std::size_t>(count);
  }
  std::string().swap(unsent_);
  sent_ = 0;
  return !is_broken_;
}

Connection::Steady::time_point Connection::send_deadline() const {
  constexpr std::size_t kMinRate = 64 << 10;  // bytes per second
  return unsent_since_ + milliseconds(5000 + 1000 * unsent_.size() / kMinRate);
}

/// True if the client has neither closed the connection nor stopped reading.
bool Connection::accepts_more() {
  if (!send_unsent() || (unsent() > 0 && Steady::now() > send_deadline())) return false;
  pollfd watched{socket_, POLLRDHUP, 0};
  return poll(&watched, 1, 0) == 0;
}

void Connection::end_sending() { shutdown(socket_, SHUT_WR); }

bool Connection::has_unread_input() const {
  int bytes = 0;
  const bool has_arrived = ioctl(socket_, FIONREAD, &bytes) == 0 && bytes > 0;
  return has_arrived || (status_ >= 400 && may_have_body(request_));
}

bool Connection::discard_input() {
  constexpr std::size_t kMax = 16 << 20;
  char part[16 << 10];
  while (discarded_bytes_ < kMax) {
    const ssize_t count = recv(socket_, part, sizeof part, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 && would_block(errno);
    discarded_bytes_ += static_cast<std::size_t>(count);
  }
  return false;
}

}  // namespace capstan
