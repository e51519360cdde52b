#pragma once
// The daemon without its HTTP server: takes studies from clients, and has their cases computed.
//
// Its whole state is in the database and in the run directories. So the next daemon can continue after a kill
// at any moment.
//
// Threads: one thread, that of the loop, calls tick, drain, has_ended and is_idle. All other functions may be
// called from any thread; most calls come from those that answer HTTP requests. Locks: the queue and its
// database are used by one thread at a time, which holds QueueWriter::mutex: the loop during a tick, a client
// during a change. Queries use connections of their own (Readers) and wait for nobody. Submissions has two
// more mutexes; submissions.hpp states the order of locking.
#include <functional>
#include <optional>
#include <string>

#include "runner/daemon/delete_study.hpp"
#include "runner/daemon/executor.hpp"
#include "runner/daemon/free_space.hpp"
#include "runner/daemon/queue_writer.hpp"
#include "runner/daemon/scheduler.hpp"
#include "runner/daemon/submissions.hpp"
#include "runner/store/data_directory.hpp"
#include "runner/store/readers.hpp"

namespace capstan {

class Service {
 public:
  /// Takes over from an earlier daemon (take_over.hpp).
  /// \param lease  a run that uses no processor time for so long is killed
  Service(const DataDirectory& data, Executor& executor, const Clock& clock, RunLimits limits = {},
          std::chrono::milliseconds lease = JobQueue::kLease);

  // Clients. Changes throw DatabaseDamaged or DatabaseUnavailable if the database cannot be written to.

  Readers::Reader reader() { return readers_.take(); }
  /// Returns once the study is safe on the disk.
  /// \param key  the Idempotency-Key, or "". Throws KeyReused if the key was sent with another study before.
  Submission submit(const Study& study, const std::string& key = "");
  // The following return the number of cases concerned; nothing if there is no such study.
  std::optional<int> cancel(const std::string& study_id);
  std::optional<int> set_priority(const std::string& study_id, int priority);
  std::optional<int> pause(const std::string& study_id, bool is_paused);
  std::optional<int> retry(const std::string& study_id);
  /// Deletes the study and those of its cases that no other study wants. The next ticks remove their rows,
  /// then their run directories. Nothing if there is no such study.
  std::optional<Deletion> remove(const std::string& study_id);
  /// Retries failed and diverged cases at another fidelity. Returns the issues of that fidelity; if there are
  /// any, nothing is retried. An unknown study has no cases to retry.
  Issues retry_at(const std::string& study_id, const nlohmann::json& fidelity);

  /// Why no run is started, as a sentence for users; "" if runs are started.
  std::string why_nothing_starts() const;
  /// From now on nothing is written, as the database was found to be damaged.
  void report_damage(const std::string& what) { writer_.report_damage(what); }
  /// Throws DatabaseError if the database is damaged, or if its files were removed or replaced.
  void expect_sound_database() const { writer_.expect_sound(); }

  const DataDirectory& data() const { return data_; }
  /// Where the cases are computed. Valid as long as the service.
  RunPlaces places() const;
  const Executor& executor() const { return executor_; }

  // Before the service is used:

  /// No run is started while the disk of the run directories has less free space than this.
  void keep_free(std::uintmax_t bytes) { free_space_.set_min_free(bytes); }
  /// \param callback  called after each change of the queue by a client, from the client's thread
  void on_change(std::function<void()> callback) { changed_ = std::move(callback); }

  // The loop (scheduler.hpp):

  void tick();
  void drain() { scheduler_.drain(); }
  bool has_ended() const { return scheduler_.has_ended(); }
  bool is_idle() const { return scheduler_.is_idle(); }

 private:
  std::optional<int> change(const std::function<std::optional<int>(JobQueue&)>& action);

  const DataDirectory& data_;
  Executor& executor_;
  std::function<void()> changed_ = [] {};
  FreeSpace free_space_;
  QueueWriter writer_;
  Readers readers_;
  Submissions submissions_;
  Scheduler scheduler_;
};

}  // namespace capstan
