#include "runner/store/database.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "runner/store/history_columns.hpp"
#include "runner/store/schema.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

bool is_unavailable(int code) {
  switch (code & 0xff) {  // the rest says more closely what kind
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_BUSY:
      return true;
  }
  return false;
}

bool is_damage(int code) { return (code & 0xff) == SQLITE_CORRUPT || (code & 0xff) == SQLITE_NOTADB; }

[[noreturn]] void fail(sqlite3* connection, const std::string& operation) {
  if (!connection) throw DatabaseError("database: " + operation + ": out of memory");
  const char* name = sqlite3_db_filename(connection, "main");
  const std::string what =
      "database " + std::string(name ? name : "") + ": " + operation + ": " + sqlite3_errmsg(connection);
  const int code = sqlite3_errcode(connection);
  if (is_damage(code)) throw DatabaseDamaged(what + kWhatToDoAboutDamage);
  if (is_unavailable(code)) throw DatabaseUnavailable(what);
  throw DatabaseError(what);
}

/// SQLite counts its memory behind one lock for all threads, which then wait for each other at every
/// allocation.
void count_no_memory() {
  static const int once = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  static_cast<void>(once);
}

std::size_t format_of(Database& database) {
  Statement version = database.query("PRAGMA user_version");
  version.step();
  return static_cast<std::size_t>(version.integer(0));
}

}  // namespace

IdleStatements::~IdleStatements() {
  for (sqlite3_stmt* statement : idle_) sqlite3_finalize(statement);
}

sqlite3_stmt* IdleStatements::take(std::string_view sql) {
  const auto found = std::find_if(idle_.rbegin(), idle_.rend(),
                                  [&](sqlite3_stmt* statement) { return sqlite3_sql(statement) == sql; });
  if (found == idle_.rend()) return nullptr;
  sqlite3_stmt* statement = *found;
  idle_.erase(std::next(found).base());
  return statement;
}

void IdleStatements::give_back(sqlite3_stmt* statement) {
  sqlite3_reset(statement);
  sqlite3_clear_bindings(statement);
  idle_.push_back(statement);
  if (idle_.size() <= kMax) return;
  sqlite3_finalize(idle_.front());
  idle_.erase(idle_.begin());
}

Statement::Statement(sqlite3* connection, std::shared_ptr<IdleStatements> idle, std::string_view sql)
    : connection_(connection), statement_(idle->take(sql), GiveBack{idle}) {
  if (statement_) return;
  sqlite3_stmt* statement = nullptr;
  const int code =
      sqlite3_prepare_v2(connection, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) fail(connection, std::string(sql));
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(connection_, sqlite3_sql(statement_.get()));
}

void Statement::bind(int index, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), index, value));
}

void Statement::bind(int index, double value) { check(sqlite3_bind_double(statement_.get(), index, value)); }

void Statement::bind(int index, std::string_view value) {
  const auto size = static_cast<int>(value.size());
  check(sqlite3_bind_text(statement_.get(), index, value.data(), size, SQLITE_TRANSIENT));
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  fail(connection_, sqlite3_sql(statement_.get()));
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const {
  if (is_null(column)) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const unsigned char* bytes = sqlite3_column_text(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return bytes ? std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size))
               : std::string();
}

Database::Database(const std::filesystem::path& file, Access access)
    : Database(file,
               access == Access::write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY) {
  if (access == Access::read) return;
  probe_ = std::make_unique<WriteProbe>(std::filesystem::absolute(file).parent_path());
  prepare_for_writing();
  files_ = std::make_unique<FilesInPlace>(file);
}

Database::Database(const std::filesystem::path& file, int flags) {
  count_no_memory();
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) fail(connection, "open " + file.string());
  sqlite3_busy_timeout(connection, 5000);
}

/// An answered submission must survive a power failure: FULL syncs the log at every commit.
void Database::prepare_for_writing() {
  execute_script("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
  bring_to_present_format();
}

void Database::bring_to_present_format() {
  Transaction transaction(*this);
  const auto steps = migrations();
  const std::size_t found = format_of(*this);
  if (found > steps.size())
    throw DatabaseError("the database has format " + std::to_string(found) + ", this program reads format " +
                        std::to_string(steps.size()));
  if (found == 0) execute_script(kQueueTables);
  if (found > 0 && found < steps.size()) {
    for (const char* step : steps.subspan(found)) execute_script(step);
    execute_script(kRecount);
  }
  if (found < steps.size()) execute_script(("PRAGMA user_version = " + std::to_string(steps.size())).c_str());
  add_history_columns(*this);
  transaction.commit();
}

void Database::expect_in_place() const {
  const std::string fault = files_ ? files_->fault() : "";
  if (!fault.empty())
    throw DatabaseUnavailable(
        fault +
        " while it was in use: nothing is written any more. What was stored can still be read "
        "(capstan results) until the server ends; then put a backup in its place and start it again");
}

void Database::expect_writable() const {
  expect_in_place();
  const std::string fault = probe_ ? probe_->fault() : "";
  if (!fault.empty())
    throw DatabaseUnavailable("database " + std::string(sqlite3_db_filename(connection_.get(), "main")) +
                              ": nothing can be written: " + fault);
}

void Database::execute_script(const char* sql) {
  if (sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(connection_.get(), sql);
}

void Database::copy_to(const std::filesystem::path& file) {
  PendingFile pending(file);
  std::filesystem::remove(pending.temporary());
  {
    Database copy(pending.temporary(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    sqlite3_backup* copying = sqlite3_backup_init(copy.connection_.get(), "main", connection_.get(), "main");
    if (!copying) fail(copy.connection_.get(), "copy");
    sqlite3_backup_step(copying, -1);
    if (sqlite3_backup_finish(copying) != SQLITE_OK) fail(copy.connection_.get(), "copy");
    copy.execute_script("PRAGMA journal_mode = DELETE");  // all in one file
    Statement check = copy.query("PRAGMA integrity_check");
    if (!check.step() || check.text(0) != "ok") throw DatabaseError("the copy is damaged: " + check.text(0));
  }
  pending.publish();
}

/// IMMEDIATE: a transaction that reads first and then writes would fail when another one wrote in between.
Transaction::Transaction(Database& database, Survives survives)
    : database_(database), is_open_(!database.in_transaction()) {
  if (!is_open_) return;
  database_.expect_writable();
  database_.execute_script(survives == Survives::power_failure ? "PRAGMA synchronous = FULL"
                                                               : "PRAGMA synchronous = NORMAL");
  database_.execute_script("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    if (database_.in_transaction()) database_.execute_script("ROLLBACK");
  } catch (const DatabaseError&) {  // the connection is broken, and SQLite has rolled back
  }
}

void Transaction::commit() {
  if (is_open_) database_.execute_script("COMMIT");
  is_open_ = false;
}

}  // namespace capstan
