#pragma once
// The database's tables.

namespace capstan {

/// The text of schema/queue.sql.
extern const char* const kQueueSchema;

/// Stored as the database's user_version; a database of another version is refused.
inline constexpr int kQueueSchemaVersion = 1;

}  // namespace capstan
