#pragma once
// Where the server listens, and where clients look for it.
#include <string>

namespace capstan {

struct Address {
  std::string host;
  int port = 0;  ///< 0: any free one
};

/// Reads "127.0.0.1:8017" or "[::1]:8017". Throws std::invalid_argument.
Address parse_address(const std::string& text);

/// Nobody but this machine can reach it.
bool is_loopback(const Address& address);

std::string url_of(const Address& address);

}  // namespace capstan
