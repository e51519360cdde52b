#pragma once
// Changes of the database that are made together or not at all.

namespace capstan {

class Database;

/// What a commit survives. Answers to clients are synced to the disk. Progress of runs is not: after a power
/// failure it is rebuilt from the run directories.
enum class Survives { kill, power_failure };

/// The destructor undoes the changes unless commit() was called. A transaction inside another one is a part
/// of that one: both are committed or undone together.
class Transaction {
 public:
  explicit Transaction(Database& database, Survives survives = Survives::power_failure);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  Database& database_;
  bool is_open_;  ///< this object began the transaction and has not committed it
};

}  // namespace capstan
