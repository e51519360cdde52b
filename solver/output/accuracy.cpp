#include "solver/output/accuracy.hpp"

#include <cmath>

#include "solver/case/shown_number.hpp"
#include "solver/observe/error_estimate.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Two significant digits, rounded up: an estimate has no more.
ordered_json two_digits(double error) {
  if (!std::isfinite(error) || error <= 0) return nullptr;
  const double unit = std::pow(10., std::floor(std::log10(error)) - 1);
  return std::stod(rounded(std::ceil(error / unit - 1e-9) * unit, 2));
}

Motion motion_of(const FinishedRun& run) {
  const ordered_json& word = run.result["motion"];
  return word.is_string() ? parse_word<Motion>(word.get<std::string>()).value_or(Motion::undecided)
                          : Motion::undecided;
}

double end_of(const FinishedRun& run) { return run.history.empty() ? 0 : run.history.back()["kt"]; }

EstimatedRun estimated(const FinishedRun& run) {
  return {.parameters = run.parameters,
          .kt = end_of(run),
          .half_turns = run.result["evidence"]["turns"],
          .largest_dihedral = run.result["trust"]["surface"]["largest_dihedral"]};
}

ErrorEstimate estimate(const FinishedRun& run, const FinishedRun& companion) {
  return estimated_error(estimated(run), estimated(companion),
                         distance_between(run.history, companion.history));
}

ordered_json description(const FinishedRun& run) {
  ordered_json shown = {{"nodes", run.parameters.fidelity.nodes}};
  if (run.parameters.has_grid()) shown["dx"] = run.parameters.fidelity.dx;
  shown["motion"] = run.result["motion"];
  shown["stop"] = run.result["stop"];
  shown["kt"] = end_of(run);
  shown["seconds"] = run.result["cost"]["seconds"];
  return shown;
}

ordered_json errors(const ErrorEstimate& error) {
  return {{"Q", two_digits(error.Q)},
          {"D_xy", two_digits(error.D_xy)},
          {"theta", two_digits(error.theta)},
          {"period", two_digits(error.period)}};
}

}  // namespace

std::optional<double> estimate_of(const FinishedRun& run, const FinishedRun& companion) {
  if (!run.is_answered() || !companion.is_answered()) return std::nullopt;
  return estimate(run, companion).Q;
}

ordered_json accuracy(const FinishedRun& run, const FinishedRun& companion) {
  if (!run.is_answered()) return unknown_accuracy("the run has no answer");
  if (!companion.is_answered()) {
    ordered_json unknown = unknown_accuracy("the run at the coarser resolution failed: " +
                                            companion.result["message"].get<std::string>());
    unknown["error"]["companion"] = description(companion);
    return unknown;
  }
  const ErrorEstimate error = estimate(run, companion);
  const double margin = run.result["evidence"]["margin"];
  ordered_json shown = errors(error);
  shown["label_agrees"] = motion_of(run) == motion_of(companion);
  shown["companion"] = description(companion);
  return {{"confirmed", is_confirmed(motion_of(run), margin, motion_of(companion), error)}, {"error", shown}};
}

ordered_json unknown_accuracy(const std::string& reason) {
  return {
      {"confirmed", false},
      {"error",
       {{"Q", nullptr}, {"D_xy", nullptr}, {"theta", nullptr}, {"period", nullptr}, {"unknown", reason}}}};
}

}  // namespace capstan
