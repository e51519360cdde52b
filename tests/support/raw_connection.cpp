#include "tests/support/raw_connection.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>

namespace capstan {
namespace {

constexpr int kMinute = 60'000;  // ms

/// False if the event does not happen within a minute.
bool is_ready(int socket, short events) {
  pollfd watched{socket, events, 0};
  return poll(&watched, 1, kMinute) > 0;
}

}  // namespace

RawConnection::RawConnection(const std::string& url)
    : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::atoi(url.c_str() + url.rfind(':') + 1)));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error("cannot connect to " + url);
}

RawConnection::~RawConnection() {
  if (socket_ >= 0) close(socket_);
}

bool RawConnection::send(std::string_view bytes) {
  while (!bytes.empty()) {
    if (!is_ready(socket_, POLLOUT)) return false;
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && errno != EAGAIN) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void RawConnection::finish_sending() { shutdown(socket_, SHUT_WR); }

std::string RawConnection::receive(std::size_t max_bytes) {
  std::string all;
  char part[4096];
  while (all.size() < max_bytes) {
    if (!is_ready(socket_, POLLIN)) throw std::runtime_error("the server neither answers nor closes");
    const ssize_t count = recv(socket_, part, std::min(sizeof part, max_bytes - all.size()), 0);
    if (count <= 0) break;
    all.append(part, static_cast<std::size_t>(count));
  }
  return all;
}

bool RawConnection::closes_within(std::chrono::milliseconds time) {
  pollfd watched{socket_, POLLRDHUP, 0};
  return poll(&watched, 1, static_cast<int>(time.count())) > 0;
}

std::string RawConnection::receive_all() { return receive(static_cast<std::size_t>(-1)); }

int status_of(std::string_view answer) {
  constexpr std::string_view kStart = "HTTP/1.1 ", kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
  if (answer.starts_with(kContinue)) answer.remove_prefix(kContinue.size());
  return answer.starts_with(kStart) ? std::atoi(std::string(answer.substr(kStart.size(), 3)).c_str()) : 0;
}

std::string request_text(const std::string& method, const std::string& target, const std::string& fields,
                         const std::string& body) {
  const std::string length =
      body.empty()
          ? ""
          : "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n";
  return method + " " + target + " HTTP/1.1\r\nHost: localhost\r\n" + fields + length + "\r\n" + body;
}

}  // namespace capstan
