#pragma once
// The daemon's only writing connection to the database, with the job queue on it.
#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "runner/queue/job_queue.hpp"
#include "runner/store/clock.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// Shared by the threads of the clients and the thread of the loop: hold `mutex` while using `database` or
/// `queue`. The member functions do not need it: any thread may call them, with or without `mutex`.
class QueueWriter {
 public:
  QueueWriter(const std::filesystem::path& file, const Clock& clock, std::chrono::milliseconds lease)
      : database(file, Database::Access::write), queue(database, clock, lease) {}

  /// Stops all further writing, as the database was found to be damaged.
  void report_damage(const std::string& what);
  /// Called before each change. Throws DatabaseDamaged after report_damage, and DatabaseUnavailable if the
  /// files of the database were removed or replaced.
  void expect_sound() const;

  std::mutex mutex;
  Database database;
  JobQueue queue;

 private:
  mutable std::mutex damage_mutex_;  ///< guards damage_
  std::string damage_;               ///< "" while no damage is known
};

}  // namespace capstan
