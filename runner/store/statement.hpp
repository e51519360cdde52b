#pragma once
// One SQL statement: values are bound to it, rows are read from it. Compiled statements are kept for reuse.
#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runner/store/clock.hpp"

namespace capstan {

/// Compiled statements of one connection that are not in use. Compiling takes longer than most statements
/// run, but a compiled one takes some 20 kB: beyond kMax the one that was used least recently is dropped.
class IdleStatements {
 public:
  static constexpr std::size_t kMax = 64;
  ~IdleStatements();
  sqlite3_stmt* take(std::string_view sql);  ///< nullptr if there is none
  void give_back(sqlite3_stmt* statement);

 private:
  std::vector<sqlite3_stmt*> idle_;  ///< the most recently used last
};

class Statement {
 public:
  /// Compiles the statement, unless `idle` has it.
  Statement(sqlite3* connection, std::shared_ptr<IdleStatements> idle, std::string_view sql);

  /// Binds the parameters ?1, ?2, … in the order of the arguments.
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

  /// Goes to the next row; false if there is none.
  bool step();

  // Columns of the present row, counted from 0:
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

}  // namespace capstan
