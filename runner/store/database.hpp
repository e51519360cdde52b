#pragma once
// SQLite with values in and out, errors as exceptions, and nothing left open.
#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "runner/store/clock.hpp"
#include "runner/store/files_in_place.hpp"
#include "runner/store/write_probe.hpp"

namespace capstan {

/// Names the database file and what failed.
class DatabaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The fault is not the statement's: the disk is full or read-only, the file is gone, another process holds
/// it. Later the same may succeed.
class DatabaseUnavailable : public DatabaseError {
 public:
  using DatabaseError::DatabaseError;
};

/// Pages of the file are not what SQLite has written.
class DatabaseDamaged : public DatabaseError {
 public:
  using DatabaseError::DatabaseError;
};

/// Where such a fault is told to people.
inline constexpr const char* kWhatToDoAboutDamage =
    ": the database is damaged. Stop the server; capstan doctor says what is damaged and mends what it can "
    "(--repair); else put the newest backup in its place as capstan.sqlite";

/// Statements that were compiled before and wait for their next use: compiling costs more than running. Each
/// takes some 20 kB, so beyond a number the one that was not used for longest goes.
class IdleStatements {
 public:
  static constexpr std::size_t kMax = 64;
  ~IdleStatements();
  sqlite3_stmt* take(std::string_view sql);  ///< nullptr if there is none
  void give_back(sqlite3_stmt* statement);

 private:
  std::vector<sqlite3_stmt*> idle_;  ///< the last used last
};

/// One SQL statement with its values bound; rows come one by one.
class Statement {
 public:
  Statement(sqlite3* connection, std::shared_ptr<IdleStatements> idle, std::string_view sql);

  /// Binds parameter ?1, ?2, … in the order of the arguments.
  template <class... Values>
  void bind_all(const Values&... values) {
    int index = 0;
    (bind(++index, values), ...);
  }
  void bind(int index, std::int64_t value);
  void bind(int index, int value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, double value);  ///< NaN becomes NULL
  void bind(int index, std::string_view value);
  void bind(int index, const std::string& value) { bind(index, std::string_view(value)); }
  void bind(int index, const char* value) { bind(index, std::string_view(value)); }
  void bind(int index, Time value) {
    bind(index, static_cast<std::int64_t>(value.time_since_epoch().count()));
  }

  /// True while there is a row to read.
  bool step();

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;  ///< NaN for NULL
  std::string text(int column) const;

 private:
  void check(int code) const;

  struct GiveBack {
    std::shared_ptr<IdleStatements> idle;
    void operator()(sqlite3_stmt* statement) const { idle->give_back(statement); }
  };
  sqlite3* connection_;
  std::unique_ptr<sqlite3_stmt, GiveBack> statement_;
};

/// One connection. There is one writer a process, and it is not shared between threads without a lock;
/// readers are as many as wanted and see the last commit.
class Database {
 public:
  enum class Access { write, read };

  /// A writer makes the database and its tables if they are not there, and brings an older format to the
  /// present one. Throws DatabaseError for a later one.
  Database(const std::filesystem::path& file, Access access);

  template <class... Values>
  Statement query(std::string_view sql, const Values&... values) {
    Statement statement(connection_.get(), idle_, sql);
    statement.bind_all(values...);
    return statement;
  }

  /// Runs a statement to its end; the number of rows that it changed.
  template <class... Values>
  int execute(std::string_view sql, const Values&... values) {
    Statement statement = query(sql, values...);
    while (statement.step()) {
    }
    return sqlite3_changes(connection_.get());
  }

  void execute_script(const char* sql);

  /// Replaces the file by a copy of one moment, whatever is written meanwhile. The copy has been checked.
  void copy_to(const std::filesystem::path& file);

  /// Throws DatabaseUnavailable where nothing can be written. To be asked before each write: the index of
  /// SQLite's log is a file in shared memory, and on a disk that has failed its first change is no error but
  /// the end of the process (SIGBUS; seen on XFS). From any thread.
  void expect_writable() const;
  /// Throws DatabaseUnavailable if the files of a writer were removed or replaced. From any thread.
  void expect_in_place() const;
  bool in_transaction() const { return sqlite3_get_autocommit(connection_.get()) == 0; }

 private:
  Database(const std::filesystem::path& file, int flags);
  void prepare_for_writing();
  void bring_to_present_format();

  struct Close {
    void operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }
  };
  std::unique_ptr<sqlite3, Close> connection_;
  std::shared_ptr<IdleStatements> idle_ = std::make_shared<IdleStatements>();
  // Of a writer:
  std::unique_ptr<WriteProbe> probe_;
  std::unique_ptr<FilesInPlace> files_;
};

/// What a commit outlives. A promise to a client waits for the disk; what only says how far a run is need
/// not: who died in a power failure runs no more, and its run directory says the rest.
enum class Survives { kill, power_failure };

/// All or nothing. Inside another transaction it is a part of that one, and undone with it.
class Transaction {
 public:
  explicit Transaction(Database& database, Survives survives = Survives::power_failure);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  Database& database_;
  bool is_open_;  ///< and to be ended here
};

}  // namespace capstan
