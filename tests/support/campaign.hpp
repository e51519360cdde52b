#pragma once
// What the tests that kill share: which moments there are to die at, and what must hold afterwards.
#include <sys/types.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace capstan {

/// All fail points of the daemon (runner/store/fail_point.hpp), in the order in which a case passes them.
inline constexpr std::array kFailPoints = {"submitting", "submitted", "claimed",   "prepared",
                                           "spawned",    "started",   "recording", "recorded"};

/// What came of a case, without what differs from run to run (times, memory).
struct Answer {
  std::string state;
  std::string result;   ///< result.json without its cost
  std::string history;  ///< the rows of the database
  int answers = 0;      ///< attempts that ended with one
  bool operator==(const Answer&) const = default;
};

/// All cases of the data directory, by id.
std::map<std::string, Answer> answers_in(const std::filesystem::path& data);

/// What holds at every moment, whoever was killed: pages, references, sums, at most one answer a case, one
/// open attempt a running case. "" or what does not.
std::string broken_promise(const std::filesystem::path& data);

/// Processes of runs that are recorded as running and are alive.
std::vector<pid_t> workers_of(const std::filesystem::path& data);

}  // namespace capstan
