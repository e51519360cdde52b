#pragma once
// Where the clients look for the server.
#include <string>

namespace capstan {

inline constexpr const char* kDefaultServer = "http://127.0.0.1:8017";

struct ServerUrl {
  bool is_secure = false;
  std::string host;  ///< of an IPv6 address without brackets
  int port = 0;
  std::string prefix;  ///< of all paths, where a proxy asks for one: "/capstan"; or ""

  std::string authority() const;  ///< "[::1]:8017"; without the port where it is the scheme's
};

/// Reads "http://127.0.0.1:8017", "https://[::1]", "HTTP://example.org/capstan/" or, without a scheme,
/// HOST:PORT. Throws std::invalid_argument that says what a URL looks like.
ServerUrl parse_server_url(const std::string& text);

}  // namespace capstan
