#include "runner/store/statement.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "runner/store/database_error.hpp"

namespace capstan {

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
    : connection_(connection), statement_{idle->take(sql), GiveBack{std::move(idle)}} {  // from left to right
  if (statement_) return;
  sqlite3_stmt* statement = nullptr;
  const int code =
      sqlite3_prepare_v2(connection, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) throw_database_error(connection, std::string(sql));
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) throw_database_error(connection_, sqlite3_sql(statement_.get()));
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
  throw_database_error(connection_, sqlite3_sql(statement_.get()));
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

}  // namespace capstan
