#include "runner/worker/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "runner/worker/timed_run.hpp"
#include "solver/case/ladder.hpp"
#include "solver/case/run_cost.hpp"

namespace capstan {
namespace {

constexpr double kMeasurementSeconds = 2;  // of all measurements together
constexpr std::size_t kMaxMeasurements = 8;

/// Cases of one kind differ only in the values of physical parameters and in the time step.
std::string kind_of(const Case& c) {
  const nlohmann::ordered_json json = to_json(c);
  nlohmann::json fidelity = json["fidelity"];
  fidelity.erase("kdt");
  return json["fluid"].dump() + fidelity.dump() + std::to_string(c.fidelity.nodes) +
         (c.has_viscosity_ratio() ? "V" : "") + (c.has_bending() ? "E" : "");
}

struct Measurement {
  const Case* measured;
  double ratio;  ///< measured seconds over run_cost()
};

double distance(const Case& a, const Case& b) {
  return std::hypot(std::log(a.Ca / b.Ca), std::log(a.V / b.V));
}

/// Measures as many cases of a kind as there is time for, evenly spread over the list.
std::vector<Measurement> measure(const std::vector<const Case*>& kind, std::size_t kinds,
                                 const CaseTimer& time) {
  const std::size_t count = std::min(kind.size(), std::max<std::size_t>(1, kMaxMeasurements / kinds));
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < count; ++i) {
    const Case& c = *kind[(2 * i + 1) * kind.size() / (2 * count)];
    const Case run = single_run(c);
    measurements.push_back({&c, time(run, kMeasurementSeconds / double(count * kinds)) / run_cost(run)});
  }
  return measurements;
}

}  // namespace

double time_by_short_run(const Case& c, double seconds) {
  const TimedRun run = timed_run(c, seconds);
  if (run.kt == 0) return run_cost(c);  // the first step already failed
  const double steps_to_end = double(run.steps) * c.until.kt / run.kt;
  return run.seconds_per_step() * steps_to_end;
}

std::vector<double> estimated_seconds(const std::vector<Case>& cases, const CaseTimer& time) {
  std::map<std::string, std::vector<const Case*>> kinds;
  for (const Case& c : cases) kinds[kind_of(c)].push_back(&c);
  std::map<std::string, std::vector<Measurement>> measurements;
  for (const auto& [kind, members] : kinds) measurements[kind] = measure(members, kinds.size(), time);
  std::vector<double> seconds;
  for (const Case& c : cases) {
    const Measurement& nearest = *std::ranges::min_element(
        measurements[kind_of(c)], {}, [&](const Measurement& other) { return distance(c, *other.measured); });
    seconds.push_back(case_cost(c) * nearest.ratio);
  }
  return seconds;
}

double wall_seconds(const std::vector<double>& seconds, int cores) {
  const double total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  const double longest = *std::ranges::max_element(seconds);
  return std::max(longest, total / cores + (cores > 1 ? longest / 2 : 0));
}

}  // namespace capstan
