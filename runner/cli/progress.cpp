#include "runner/cli/progress.hpp"

#include <cmath>
#include <ostream>

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::string bar(double progress) {
  constexpr int kWidth = 30;
  const int full = static_cast<int>(kWidth * progress);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(kWidth - full), '.') + "]";
}

std::string counts_text(const ordered_json& cases) {
  const int ended = cases["total"].get<int>() - cases["queued"].get<int>() - cases["running"].get<int>();
  std::string text = std::to_string(ended) + " of " + cases["total"].dump() + " cases";
  for (const char* state : {"running", "failed", "diverged", "cancelled"})
    if (cases[state] > 0) text += ", " + cases[state].dump() + " " + state;
  return text;
}

/// Points that a search will probably still ask for.
std::string expected_text(const ordered_json& study) {
  const int expected = study.value("expected_points", 0);
  return expected > 0 ? ", about " + std::to_string(expected) + " more expected" : "";
}

std::string percent(double progress) {
  const std::string number = std::to_string(static_cast<int>(100 * progress));
  return std::string(4 - std::min<std::size_t>(4, number.size()), ' ') + number + " %";
}

}  // namespace

std::string progress_text(const ordered_json& study) {
  const double progress = study["progress"];
  return bar(progress) + percent(progress) + "  " + counts_text(study["cases"]) + expected_text(study);
}

std::string duration_text(std::chrono::seconds duration) {
  const auto seconds = duration.count();
  if (seconds < 100) return std::to_string(seconds) + " s";
  const auto minutes = (seconds + 30) / 60;
  if (minutes < 100) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

std::optional<std::chrono::seconds> ProgressLine::time_left(double progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!first_progress_) {
    first_progress_ = progress;
    first_time_ = now;
  }
  const double gained = progress - *first_progress_;
  if (gained < 1e-3) return std::nullopt;
  const std::chrono::duration<double> spent = now - first_time_;
  return std::chrono::seconds(std::lround(spent.count() * (1 - progress) / gained));
}

void ProgressLine::show(const ordered_json& study) {
  const auto left = time_left(study["progress"]);
  if (is_terminal_) {
    const std::string end = left ? ", " + duration_text(*left) + " left" : "";
    out_ << "\r\x1b[K" << progress_text(study) << end << std::flush;
    return;
  }
  const std::string counts = counts_text(study["cases"]);
  if (counts == shown_) return;
  shown_ = counts;
  out_ << progress_text(study) << std::endl;
}

void ProgressLine::finish() {
  if (is_terminal_) out_ << std::endl;
}

}  // namespace capstan
