#pragma once
// The target of a request, "/path?query": split, and its %-escapes decoded.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/web/message.hpp"

namespace capstan {

/// Nothing where a % is not followed by two hexadecimal digits.
std::optional<std::string> percent_decoded(std::string_view text);

/// The decoded segments of a path: "/v1/studies/a%2Fb" → "v1", "studies", "a/b". Its escapes have been
/// checked.
std::vector<std::string> path_segments(std::string_view path);

/// "a=1&b=2" in order; "+" is a space. Its escapes have been checked.
Query read_query(std::string_view text);

}  // namespace capstan
