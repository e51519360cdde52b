#pragma once
// Requests that are valid HTTP, but that this server does not support.
#include <httplib.h>

#include <cstddef>
#include <optional>

#include "runner/web/response.hpp"

namespace capstan {

inline constexpr std::size_t kMaxBody = 1 << 20;  ///< bytes; a study of 10,000 listed values has 100 kB

/// 411 for a chunked body, 413 for one that is too large, 415 for one that is compressed or not JSON, 416 for
/// a range, 417 for an expectation other than 100-continue.
std::optional<Response> refuse_unsupported(const httplib::Request& request);

}  // namespace capstan
