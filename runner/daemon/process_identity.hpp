#pragma once
// One process, never to be mistaken for another: a pid alone is used again.
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

/// Nothing if there is no such process, or if it has ended and waits to be reaped.
std::optional<ProcessIdentity> identify(pid_t pid);

struct ProcessUsage {
  double cpu_seconds = 0;
  double resident_mb = 0;
};

std::optional<ProcessUsage> usage_of(const ProcessIdentity& process);

/// Stored as "PID:START:BOOT".
std::string to_text(const ProcessIdentity& process);
std::optional<ProcessIdentity> process_from_text(const std::string& text);

bool is_alive(const ProcessIdentity& process);

/// Waits for the end of a process that may be nobody's child; false after `milliseconds`.
bool wait_for_end(const ProcessIdentity& process, int milliseconds);

}  // namespace capstan
