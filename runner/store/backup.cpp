#include "runner/store/backup.hpp"

#include <stdexcept>

#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::invalid_argument(file.string() + " " + why + ": choose another file for the copy");
}

/// The database and SQLite's files beside it, the lock, the request log, the runs.
bool is_name_in_a_data_directory(const std::string& name) {
  return name.starts_with(kDatabaseName) || name.starts_with("requests.log") || name == kDataLockName ||
         name == kRunsName;
}

bool is_data_directory(const fs::path& directory) {
  return fs::exists(directory / kDataLockName) && fs::exists(directory / kRunsName);
}

/// True for a database of Capstan that no process has open.
bool is_backup(const fs::path& file) try {
  if (fs::exists(file.string() + "-wal")) return false;
  Database copy(file, Database::Access::read);
  copy.query("SELECT 1 FROM studies JOIN cases").step();
  return true;
} catch (const DatabaseError&) {
  return false;
}

void expect_replaceable(const fs::path& data, const fs::path& file) {
  const fs::path directory = fs::absolute(file).parent_path();
  if (!fs::is_directory(directory))
    refuse(file, "cannot be written, as " + directory.string() + " is no directory");
  const bool is_needed = fs::equivalent(directory, data) || is_data_directory(directory);
  if (is_needed && is_name_in_a_data_directory(file.filename())) refuse(file, "belongs to a data directory");
  const fs::file_status status = fs::symlink_status(file);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse(file, "is no regular file");
  if (fs::equivalent(file, data / kDatabaseName)) refuse(file, "is the database itself");
  if (!is_backup(file)) refuse(file, "is there already and is no earlier copy of a database");
}

/// Copies all pages, makes the copy a single file, and checks it.
void write_copy(sqlite3* source, const fs::path& file) {
  const SqliteConnection copy = open_connection(file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  sqlite3_backup* backup = sqlite3_backup_init(copy.get(), "main", source, "main");
  if (!backup) throw_database_error(copy.get(), "copy");
  constexpr int kAllPages = -1;
  sqlite3_backup_step(backup, kAllPages);
  if (sqlite3_backup_finish(backup) != SQLITE_OK) throw_database_error(copy.get(), "copy");
  execute_script(copy.get(), "PRAGMA journal_mode = DELETE");
  Statement check(copy.get(), std::make_shared<IdleStatements>(), "PRAGMA integrity_check");
  if (!check.step() || check.text(0) != "ok") throw DatabaseError("the copy is damaged: " + check.text(0));
}

}  // namespace

void back_up_database(const fs::path& data, const fs::path& file) {
  const SqliteConnection source = open_connection(data / kDatabaseName, SQLITE_OPEN_READONLY);
  expect_replaceable(data, file);
  PendingFile pending(file);
  fs::remove(pending.temporary());
  write_copy(source.get(), pending.temporary());
  pending.publish();
}

}  // namespace capstan
