#include "solver/output/result.hpp"

#include <sys/resource.h>

#include <cmath>

#include "solver/case/content_id.hpp"
#include "solver/case/left_out.hpp"
#include "solver/output/run_warnings.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::round(double(usage.ru_maxrss) / 1024);
}

nlohmann::ordered_json to_json(const Evidence& e) {
  return {{"n_theta", e.n_theta}, {"n_psi", e.n_psi}, {"r", e.r},
          {"D_min", e.D_min},     {"turns", e.turns}, {"theta_range", e.theta_range},
          {"margin", e.margin}};
}

/// Angles in degrees, times as kt (schema/run_directory.md).
nlohmann::ordered_json to_json(const SurfaceWatch& surface) {
  const SurfaceQuality& worst = surface.worst();
  const auto or_null = [](std::optional<double> kt) { return kt ? nlohmann::ordered_json(*kt) : nullptr; };
  return {
      {"largest_dihedral", worst.largest_dihedral},    {"folded_edges", worst.folded_edges},
      {"smallest_angle", worst.smallest_angle},        {"smallest_wavelength", smallest_wavelength(worst)},
      {"folded_from", or_null(surface.folded_from())}, {"lost_from", or_null(surface.lost_from())}};
}

/// A run that failed before its end has no motion.
Verdict verdict_of(const Simulation& simulation, const Outcome& outcome) {
  Verdict verdict = simulation.verdict();
  if (has_answer(outcome.stop)) return verdict;
  verdict.evidence.margin = 0;
  verdict.explanation = "The run failed before its end: it has no motion.";
  return verdict;
}

}  // namespace

nlohmann::ordered_json result_json(const Case& c, const Choices& choices, const Simulation& simulation,
                                   const Outcome& outcome, double seconds) {
  const RunStatistics& statistics = simulation.statistics();
  const Verdict verdict = verdict_of(simulation, outcome);
  nlohmann::ordered_json result;
  result["format"] = 1;
  result["case"] = to_json(c);
  result["choices"] = to_json(choices);
  result["stop"] = to_string(outcome.stop);
  result["message"] = outcome.message;
  result["motion"] = has_answer(outcome.stop) ? nlohmann::ordered_json(to_string(verdict.motion)) : nullptr;
  result["explanation"] = verdict.explanation;
  result["evidence"] = to_json(verdict.evidence);
  if (!simulation.history().empty())
    result["final"] = nlohmann::ordered_json::parse(to_json_line(simulation.history().back()));
  result["cost"] = {{"seconds", std::round(seconds * 1000) / 1000},
                    {"steps", statistics.steps},
                    {"flow_iterations", statistics.flow_iterations},
                    {"peak_memory_mb", peak_memory_mb()}};
  nlohmann::ordered_json& trust = result["trust"];
  trust["numerics_version"] = kNumericsVersion;
  trust["fluid"] = to_string(c.fluid);
  trust["bending"] = c.has_bending() ? to_string(c.bending) : "none";
  trust["volume_drift"] = statistics.volume_drift;
  trust["area_drift"] = statistics.area_drift;
  trust["worst_flow_error"] = statistics.worst_flow_error;
  trust["left_out"] = left_out(c);
  trust["surface"] = to_json(simulation.surface());
  trust["warnings"] = run_warnings(c, statistics, simulation.surface());
  return result;
}

}  // namespace capstan
