#include "runner/web/listen_address.hpp"

#include <arpa/inet.h>

#include <charconv>
#include <stdexcept>

#include "runner/web/ascii_case.hpp"

namespace capstan {

ListenAddress parse_listen_address(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0)
    throw std::invalid_argument("\"" + text + "\" is no address: give HOST:PORT");
  ListenAddress address{text.substr(0, colon), 0};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + colon + 1, end, address.port);
  if (read.ec != std::errc() || read.ptr != end || address.port < 0 || address.port > 65535)
    throw std::invalid_argument("\"" + text + "\" has no port from 0 to 65535");
  if (address.host.starts_with('[') && address.host.ends_with(']'))
    address.host = address.host.substr(1, address.host.size() - 2);
  return address;
}

bool is_loopback(const ListenAddress& address) {
  in_addr ipv4{};
  if (inet_pton(AF_INET, address.host.c_str(), &ipv4) == 1) return ntohl(ipv4.s_addr) >> 24 == 127;
  return address.host == "::1" || equal_ignoring_case(address.host, "localhost");
}

std::string url_of(const ListenAddress& address) {
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  return "http://" + (is_ipv6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace capstan
