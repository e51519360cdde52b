#include "runner/store/connection.hpp"

#include "runner/store/database_error.hpp"

namespace capstan {
namespace {

/// SQLite counts allocations under one lock for all threads, so that threads wait for each other.
void switch_off_memory_statistics() {
  static const int once = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  static_cast<void>(once);
}

}  // namespace

SqliteConnection open_connection(const std::filesystem::path& file, int flags) {
  constexpr int kMaxWait = 5000;  // ms
  switch_off_memory_statistics();
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  SqliteConnection opened(connection);
  if (code != SQLITE_OK) throw_database_error(connection, "open " + file.string());
  sqlite3_busy_timeout(connection, kMaxWait);
  return opened;
}

void execute_script(sqlite3* connection, const char* sql) {
  if (sqlite3_exec(connection, sql, nullptr, nullptr, nullptr) != SQLITE_OK)
    throw_database_error(connection, sql);
}

}  // namespace capstan
