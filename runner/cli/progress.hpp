#pragma once
// The progress of a study as text, for a terminal or a log.
#include <chrono>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace capstan {

/// On a terminal: one line, rewritten at each call. Elsewhere: a new line whenever the numbers of cases
/// changed.
class ProgressLine {
 public:
  ProgressLine(std::ostream& out, bool is_terminal) : out_(out), is_terminal_(is_terminal) {}

  /// \param study  as the server returns it
  void show(const nlohmann::ordered_json& study);
  /// Ends the line on a terminal.
  void finish();

 private:
  /// Extrapolated from the speed since the first call; nothing before the progress has changed.
  /// \param progress  from 0 to 1
  std::optional<std::chrono::seconds> time_left(double progress);

  std::ostream& out_;
  bool is_terminal_;
  std::string shown_;
  std::optional<double> first_progress_;
  std::chrono::steady_clock::time_point first_time_;
};

/// "[#####.....]  50 %  2 of 4 cases, 2 running"
std::string progress_text(const nlohmann::ordered_json& study);

/// "45 s", "12 min", "3 h 20 min"
std::string duration_text(std::chrono::seconds duration);

}  // namespace capstan
