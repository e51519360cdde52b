#pragma once
// How far a study is, for a terminal or for a log.
#include <chrono>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace capstan {

/// Shows one line that renews itself on a terminal; elsewhere a line whenever a case has ended or started.
class ProgressLine {
 public:
  ProgressLine(std::ostream& out, bool is_terminal) : out_(out), is_terminal_(is_terminal) {}

  /// \param study  as the server gives it
  void show(const nlohmann::ordered_json& study);
  void finish();

 private:
  /// From the speed since the first call; nothing until something has moved.
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
