#include "runner/store/readers.hpp"

namespace capstan {

Readers::Reader Readers::take() {
  std::unique_ptr<Database> database;
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      database = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!database) {
    writer_.expect_in_place();
    database = std::make_unique<Database>(file_, Database::Access::read);
  }
  database->execute_script("BEGIN");
  return Reader(database.release(), GiveBack{this});
}

/// Ends the snapshot. A connection on which that fails is closed.
void Readers::give_back(Database* held) {
  std::unique_ptr<Database> database(held);
  try {
    database->execute_script("ROLLBACK");
  } catch (const DatabaseError&) {
    return;
  }
  const std::lock_guard lock(mutex_);
  if (idle_.size() < kMaxIdle) idle_.push_back(std::move(database));
}

}  // namespace capstan
