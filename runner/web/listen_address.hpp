#pragma once
// The address at which the server listens.
#include <string>

namespace capstan {

struct ListenAddress {
  std::string host;  ///< a name or a numeric address; IPv6 without brackets
  int port = 0;      ///< 0: any free port
};

/// Parses "127.0.0.1:8017" or "[::1]:8017". Throws std::invalid_argument.
ListenAddress parse_listen_address(const std::string& text);

/// Only processes of this machine can reach it.
bool is_loopback(const ListenAddress& address);

std::string url_of(const ListenAddress& address);

}  // namespace capstan
