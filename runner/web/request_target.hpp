#pragma once
// The target of a request, "/path?query" (RFC 9112, 3.2), and its percent-encoding (RFC 3986, 2.1).
#include <httplib.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// Nothing if a % is not followed by two hexadecimal digits.
std::optional<std::string> percent_decoded(std::string_view text);

/// The decoded segments of a path: "/v1/studies/a%2Fb" → "v1", "studies", "a/b".
/// \param path  with valid escapes
std::vector<std::string> path_segments(std::string_view path);

/// The decoded parameters of "a=1&b=2", where "+" is a space. Those of one name keep their order.
/// \param text  with valid escapes
httplib::Params parse_query(std::string_view text);

}  // namespace capstan
