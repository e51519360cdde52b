#pragma once
// Changes of the database that are made together or not at all.

namespace capstan {

class Database;

/// What a commit survives. Answers to clients are synced to the disk. Progress of runs is not: after a power
/// failure it is rebuilt from the run directories.
enum class Survives { kill, power_failure };

/// Undone at its end unless it was committed. Inside another transaction it is a part of that one: it is
/// committed and undone together with it.
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
