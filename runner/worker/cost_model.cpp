#include "runner/worker/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "runner/worker/timed_run.hpp"
#include "solver/case/run_cost.hpp"

namespace capstan {
namespace {

constexpr double kProbeSeconds = 2;  // of all probes together
constexpr std::size_t kMaxProbes = 8;

/// Cases of one kind differ in parameters of the physics alone.
std::string kind_of(const Case& c) {
  const nlohmann::ordered_json json = to_json(c);
  nlohmann::json fidelity = json["fidelity"];
  fidelity.erase("kdt");
  return json["fluid"].dump() + fidelity.dump() + (c.has_viscosity_ratio() ? "V" : "") +
         (c.has_bending() ? "E" : "");
}

struct Probe {
  const Case* at;
  double scale;  ///< seconds to the end over run_cost
};

double distance(const Case& a, const Case& b) {
  return std::hypot(std::log(a.Ca / b.Ca), std::log(a.V / b.V));
}

Probe probe(const Case& c, double seconds) {
  const TimedRun run = timed_run(c, seconds);
  if (run.kt == 0) return {&c, 1};  // it broke down at once
  const double a_step = run.steady_seconds / double(std::max(1L, run.steps - 1));
  const double steps_to_end = double(run.steps) * c.until.kt / run.kt;
  return {&c, a_step * steps_to_end / run_cost(c)};
}

/// So many of the kind as there is time for, evenly spread.
std::vector<Probe> probes_of(const std::vector<const Case*>& kind, std::size_t kinds) {
  const std::size_t count = std::min(kind.size(), std::max<std::size_t>(1, kMaxProbes / kinds));
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < count; ++i)
    probes.push_back(
        probe(*kind[(2 * i + 1) * kind.size() / (2 * count)], kProbeSeconds / double(count * kinds)));
  return probes;
}

}  // namespace

std::vector<double> estimated_seconds(const std::vector<Case>& cases) {
  std::map<std::string, std::vector<const Case*>> kinds;
  for (const Case& c : cases) kinds[kind_of(c)].push_back(&c);
  std::map<std::string, std::vector<Probe>> probes;
  for (const auto& [kind, members] : kinds) probes[kind] = probes_of(members, kinds.size());
  std::vector<double> seconds;
  for (const Case& c : cases) {
    const Probe& nearest = *std::ranges::min_element(
        probes[kind_of(c)], {}, [&](const Probe& other) { return distance(c, *other.at); });
    seconds.push_back(run_cost(c) * nearest.scale);
  }
  return seconds;
}

}  // namespace capstan
