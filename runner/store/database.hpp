#pragma once
// One connection to the daemon's database, for queries and changes.
#include <filesystem>
#include <memory>
#include <string_view>

#include "runner/store/connection.hpp"
#include "runner/store/database_error.hpp"
#include "runner/store/database_files.hpp"
#include "runner/store/statement.hpp"
#include "runner/store/transaction.hpp"
#include "runner/store/write_probe.hpp"

namespace capstan {

/// A process has at most one writer, and any number of readers, which see the last commit. Each is used by
/// one thread at a time.
class Database {
 public:
  enum class Access { write, read };

  /// A writer makes the database if it is missing, and upgrades an older one to the present format. Throws
  /// DatabaseError where that cannot be done, and for a format that is newer than this program.
  Database(const std::filesystem::path& file, Access access);

  /// The statement with its values bound to ?1, ?2, …; its rows are read with step().
  template <class... Values>
  Statement query(std::string_view sql, const Values&... values) {
    Statement statement(connection_.get(), idle_, sql);
    statement.bind_all(values...);
    return statement;
  }

  /// Runs a statement to its end. Returns the number of rows that it changed.
  template <class... Values>
  int execute(std::string_view sql, const Values&... values) {
    Statement statement = query(sql, values...);
    while (statement.step()) {
    }
    return sqlite3_changes(connection_.get());
  }

  /// Runs one or more statements that return no rows.
  void execute_script(const char* sql) { capstan::execute_script(connection_.get(), sql); }

  /// Throws DatabaseUnavailable if the disk accepts no writes. Called before each write, because SQLite maps
  /// its shared memory file (-shm): on a disk that has failed, writing to it returns no error but kills the
  /// process (SIGBUS, seen on XFS). From any thread.
  void expect_writable() const;
  /// Throws DatabaseUnavailable if files of a writer were removed or replaced. From any thread.
  void expect_in_place() const;
  bool in_transaction() const { return sqlite3_get_autocommit(connection_.get()) == 0; }

 private:
  SqliteConnection connection_;
  std::shared_ptr<IdleStatements> idle_ = std::make_shared<IdleStatements>();
  // Set for a writer only:
  std::unique_ptr<WriteProbe> probe_;
  std::unique_ptr<DatabaseFiles> files_;
};

}  // namespace capstan
