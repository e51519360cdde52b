#pragma once
// SQL of the database's tables, embedded from schema/. The format of a database is its user_version; 0: it is
// new.
#include <span>

namespace capstan {

/// Makes the tables of a new database (schema/queue.sql).
extern const char* const kQueueTables;

/// Steps for older databases: that at index N - 1 leads from format N - 1 to format N
/// (schema/migrations/format_N.sql). Their number is the present format.
std::span<const char* const> migrations();

/// Fills the counts from the tables that they sum up (schema/recount.sql).
extern const char* const kRecount;

}  // namespace capstan
