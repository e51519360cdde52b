#include "runner/store/database_error.hpp"

namespace capstan {
namespace {

/// SQLite's primary result code, without the extended part in the higher bytes.
int primary(int code) { return code & 0xff; }

bool is_unavailable(int code) {
  switch (primary(code)) {
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_BUSY:
      return true;
  }
  return false;
}

bool is_damage(int code) { return primary(code) == SQLITE_CORRUPT || primary(code) == SQLITE_NOTADB; }

}  // namespace

void throw_database_error(sqlite3* connection, const std::string& operation) {
  if (!connection) throw DatabaseError("database: " + operation + ": out of memory");
  const char* name = sqlite3_db_filename(connection, "main");
  const std::string what =
      "database " + std::string(name ? name : "") + ": " + operation + ": " + sqlite3_errmsg(connection);
  const int code = sqlite3_errcode(connection);
  if (is_damage(code)) throw DatabaseDamaged(what + kWhatToDoAboutDamage);
  if (is_unavailable(code)) throw DatabaseUnavailable(what);
  throw DatabaseError(what);
}

}  // namespace capstan
