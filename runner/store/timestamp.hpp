#pragma once
// Times as text.
#include <cstdint>
#include <string>

namespace capstan {

/// RFC 3339, UTC, to the second: "2026-01-31T12:00:00Z".
std::string timestamp(std::int64_t milliseconds_since_1970);

}  // namespace capstan
