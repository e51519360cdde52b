#pragma once
// Errors of the database, one class for each way to deal with them.
#include <sqlite3.h>

#include <stdexcept>
#include <string>

namespace capstan {

/// The message names the database file and the operation that failed.
class DatabaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The environment failed: the disk is full or read-only, the file is gone, another process holds it. The
/// same operation may succeed later.
class DatabaseUnavailable : public DatabaseError {
 public:
  using DatabaseError::DatabaseError;
};

/// Pages of the file differ from what SQLite has written.
class DatabaseDamaged : public DatabaseError {
 public:
  using DatabaseError::DatabaseError;
};

/// Ends the message of a DatabaseDamaged.
inline constexpr const char* kWhatToDoAboutDamage =
    ": the database is damaged. Stop the server; capstan doctor says what is damaged and repairs what it can "
    "(--repair); else put the newest backup in its place as capstan.sqlite";

/// Throws the last error of the connection, as one of the classes above.
/// \param connection  nullptr if there was no memory to make one
[[noreturn]] void throw_database_error(sqlite3* connection, const std::string& operation);

}  // namespace capstan
