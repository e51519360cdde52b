#include "runner/bench/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "runner/bench/timed_run.hpp"

namespace capstan {
namespace {

constexpr double kProbeSeconds = 2;  // of all probes together
constexpr std::size_t kMostProbes = 8;

/// Cases of one kind differ in parameters of the physics alone.
std::string kind_of(const Case& c) {
  const nlohmann::ordered_json json = to_json(c);
  nlohmann::json fidelity = json["fidelity"];
  fidelity.erase("kdt");
  return json["fluid"].dump() + fidelity.dump() + (c.has_viscosity_contrast() ? "V" : "") +
         (c.has_bending() ? "E" : "");
}

struct Probe {
  const Case* at;
  double seconds_a_step, steps_a_kt;
};

double distance(const Case& a, const Case& b) {
  return std::hypot(std::log(a.Ca / b.Ca), std::log(a.V / b.V));
}

Probe probe(const Case& c, double seconds) {
  const TimedRun run = timed_run(c, seconds);
  return {&c, run.steady_seconds / double(std::max(1L, run.steps - 1)),
          double(run.steps_to_end) / c.until.kt};
}

/// So many of the kind as there is time for, evenly spread.
std::vector<Probe> probes_of(const std::vector<const Case*>& kind, std::size_t kinds) {
  const std::size_t count = std::min(kind.size(), std::max<std::size_t>(1, kMostProbes / kinds));
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < count; ++i)
    probes.push_back(
        probe(*kind[(2 * i + 1) * kind.size() / (2 * count)], kProbeSeconds / double(count * kinds)));
  return probes;
}

/// A lattice's own step grows with Re; a chosen one stands in the case; a stepper that chooses steps from
/// record to record.
double steps_of(const Case& c, const Probe& probe) {
  const Case& at = *probe.at;
  double shorter = 1;
  if (c.fluid == Fluid::transient)
    shorter = at.Re / c.Re;
  else if (c.fidelity.kdt > 0)
    shorter = at.fidelity.kdt / c.fidelity.kdt;
  return probe.steps_a_kt * c.until.kt * shorter;
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
    seconds.push_back(steps_of(c, nearest) * nearest.seconds_a_step);
  }
  return seconds;
}

}  // namespace capstan
