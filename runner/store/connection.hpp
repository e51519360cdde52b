#pragma once
// An SQLite connection. Its destructor closes it; its errors are exceptions (database_error.hpp).
#include <sqlite3.h>

#include <filesystem>
#include <memory>

namespace capstan {

struct CloseConnection {
  void operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }
};
using SqliteConnection = std::unique_ptr<sqlite3, CloseConnection>;

/// For one thread at a time. A statement waits up to 5 s for a lock that another process holds.
/// \param flags  of sqlite3_open_v2: SQLITE_OPEN_READONLY and so on
SqliteConnection open_connection(const std::filesystem::path& file, int flags);

/// Runs one or more statements that return no rows.
void execute_script(sqlite3* connection, const char* sql);

}  // namespace capstan
