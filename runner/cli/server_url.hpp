#pragma once
// The URL of the server, as the commands accept it.
#include <string>

namespace capstan {

inline constexpr const char* kDefaultServer = "http://127.0.0.1:8017";

struct ServerUrl {
  bool is_secure = false;
  std::string host;  ///< an IPv6 address is without brackets
  int port = 0;
  std::string prefix;  ///< put before every path, such as "/capstan" behind a proxy; or ""

  std::string authority() const;  ///< "[::1]:8017"; without the port if it is the scheme's default
};

/// Parses "http://127.0.0.1:8017", "https://[::1]", "HTTP://example.org/capstan/" or, without a scheme,
/// HOST:PORT. Throws std::invalid_argument with an example of a URL.
ServerUrl parse_server_url(const std::string& text);

}  // namespace capstan
