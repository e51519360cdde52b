#include "runner/web/listening_socket.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>

namespace capstan {
namespace {

void set_option(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

/// SO_REUSEADDR allows a quick restart. Without SO_REUSEPORT a second daemon cannot share the port unnoticed.
int listening_socket(const addrinfo& at) {
  constexpr int kBacklog = 1024;  // connections that wait to be accepted: many clients may come at once
  const int descriptor = socket(at.ai_family, at.ai_socktype | SOCK_CLOEXEC, at.ai_protocol);
  if (descriptor < 0) return -1;
  set_option(descriptor, SOL_SOCKET, SO_REUSEADDR, 1);
  if (at.ai_family == AF_INET6)
    set_option(descriptor, IPPROTO_IPV6, IPV6_V6ONLY, 0);  // [::] accepts IPv4 too
  if (bind(descriptor, at.ai_addr, at.ai_addrlen) == 0 && listen(descriptor, kBacklog) == 0)
    return descriptor;
  close(descriptor);
  return -1;
}

}  // namespace

int open_listening_socket(const ListenAddress& address) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  const std::string port = std::to_string(address.port);
  if (getaddrinfo(address.host.c_str(), port.c_str(), &hints, &found) != 0) found = nullptr;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
  for (const addrinfo* each = found; each; each = each->ai_next)
    if (const int descriptor = listening_socket(*each); descriptor >= 0) return descriptor;
  throw std::runtime_error("cannot listen on " + url_of(address) + ": is it taken?");
}

int port_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                             : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace capstan
