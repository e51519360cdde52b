#include "runner/store/database.hpp"

#include <string>

#include "runner/store/upgrade.hpp"

namespace capstan {
namespace {

int open_flags(Database::Access access) {
  return access == Database::Access::write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                                           : SQLITE_OPEN_READONLY;
}

}  // namespace

/// synchronous = FULL: a submission that was answered survives a power failure.
Database::Database(const std::filesystem::path& file, Access access)
    : connection_(open_connection(file, open_flags(access))) {
  if (access == Access::read) return;
  probe_ = std::make_unique<WriteProbe>(std::filesystem::absolute(file).parent_path());
  execute_script("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
  upgrade_to_present_format(*this);
  files_ = std::make_unique<DatabaseFiles>(file);
}

void Database::expect_in_place() const {
  const std::string change = files_ ? files_->change() : "";
  if (!change.empty())
    throw DatabaseUnavailable(
        change +
        " while it was in use: nothing is written any more. What was stored can still be read "
        "(capstan results) until the server ends; then put a backup in its place and start it again");
}

void Database::expect_writable() const {
  expect_in_place();
  const std::string error = probe_ ? probe_->error() : "";
  if (!error.empty())
    throw DatabaseUnavailable("database " + std::string(sqlite3_db_filename(connection_.get(), "main")) +
                              ": nothing can be written: " + error);
}

}  // namespace capstan
