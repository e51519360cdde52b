#include "runner/store/transaction.hpp"

#include "runner/store/database.hpp"

namespace capstan {

/// BEGIN IMMEDIATE locks at once. A transaction that locks at its first write fails with SQLITE_BUSY if
/// another one has written since its first read.
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
  } catch (const DatabaseError&) {  // the connection is broken: SQLite has rolled back
  }
}

void Transaction::commit() {
  if (is_open_) database_.execute_script("COMMIT");
  is_open_ = false;
}

}  // namespace capstan
