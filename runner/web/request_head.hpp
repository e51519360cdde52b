#pragma once
// The head of a request (RFC 9112), parsed strictly into the library's Request. A head that two parsers could
// read differently is refused, so that no request can hide in another (request smuggling).
#include <httplib.h>

#include <cstddef>
#include <optional>
#include <string_view>

#include "runner/web/response.hpp"

namespace capstan {

inline constexpr std::size_t kMaxHead = 16 << 10;  ///< bytes; a browser sends 1 kB
inline constexpr std::size_t kMaxLine = 8190;      ///< bytes, of the first line and of each header line
inline constexpr std::size_t kMaxPath = 1000;      ///< bytes

struct ParsedHead {
  /// As far as it was parsed. Set are method, target, path, params and headers; the body follows later.
  /// Unlike the library's own parser this one leaves `path` encoded, so that "%2F" stays part of its segment.
  httplib::Request request;
  std::optional<Response> refusal;  ///< 400, 414, 431, 501 or 505
};

/// \param text  the head, up to and with the empty line
ParsedHead parse_head(std::string_view text);

/// Length of the body in bytes, for a request whose head was accepted. The largest std::size_t if the length
/// exceeds every integer type.
std::size_t content_length(const httplib::Request& request);

}  // namespace capstan
