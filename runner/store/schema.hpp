#pragma once
// The database's tables, and how they came to be.
#include <span>

namespace capstan {

/// SQL that leads from format N - 1 to format N, at index N - 1 (schema/queue_N.sql). A new database runs
/// through all of them, an older one through those that it lacks; its format is its user_version.
std::span<const char* const> queue_formats();

/// Makes the sums agree with what they sum up (schema/recount.sql).
extern const char* const kRecount;

}  // namespace capstan
