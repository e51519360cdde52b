#pragma once
// For tests that kill the daemon: its fail points, and what must hold in its database afterwards.
#include <sys/types.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace capstan {

/// All fail points of the daemon (runner/store/fail_point.hpp), in the order in which a case reaches them.
inline constexpr std::array kFailPoints = {"submitting", "submitted", "claimed",   "prepared",
                                           "spawned",    "started",   "recording", "recorded"};

/// State, result and history of a case, without what differs between equal runs (time, memory).
struct Answer {
  std::string state;
  std::string result;   ///< result.json without its cost
  std::string history;  ///< all rows of the database, as one text
  int answers = 0;      ///< number of attempts that ended as done or diverged
  bool operator==(const Answer&) const = default;
};

/// All cases of the data directory by id.
std::map<std::string, Answer> answers_in(const std::filesystem::path& data);

/// Checks what must hold at every moment, whichever process was killed: valid pages and references, correct
/// sums, at most one answer a case, one open attempt for each running case. Returns what does not hold, or
/// "".
std::string broken_promise(const std::filesystem::path& data);

/// Live processes of the runs that are recorded as running.
std::vector<pid_t> workers_of(const std::filesystem::path& data);

}  // namespace capstan
