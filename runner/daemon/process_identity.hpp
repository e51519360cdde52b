#pragma once
// The identity of a process. Its process id alone is not enough, because the kernel reuses ids.
#include <sys/types.h>

#include <optional>
#include <string>

namespace capstan {

struct ProcessIdentity {
  pid_t pid = 0;
  std::string start_time;  ///< clock ticks since boot (proc(5), field 22)
  std::string boot_id;

  bool operator==(const ProcessIdentity&) const = default;
};

/// Nothing if there is no such process, or if it has ended and is not reaped yet.
std::optional<ProcessIdentity> identify(pid_t pid);

struct ProcessUsage {
  double cpu_seconds = 0;  ///< user and system time
  double resident_mb = 0;
};

/// Nothing if the process has ended.
std::optional<ProcessUsage> usage_of(const ProcessIdentity& process);

/// "PID:START_TIME:BOOT_ID"
std::string to_text(const ProcessIdentity& process);
/// The inverse of to_text; nothing if the text has another form.
std::optional<ProcessIdentity> process_from_text(const std::string& text);

bool is_alive(const ProcessIdentity& process);

/// Waits until the process has ended; false if it has not after `milliseconds`. It need not be a child of
/// this process.
bool wait_for_end(const ProcessIdentity& process, int milliseconds);

}  // namespace capstan
