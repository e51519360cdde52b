#include "solver/observe/findings.hpp"

#include <algorithm>
#include <cmath>

#include "solver/observe/shape_vector.hpp"

namespace capstan {
namespace {

Samples after_start(Samples samples) {
  constexpr double kRounding = 1e-9;
  const auto first =
      std::ranges::find_if(samples, [](const MotionSample& s) { return s.kt >= kStart - kRounding; });
  return {first, samples.end()};
}

bool is_finite(const MotionSample& s) {
  return std::isfinite(s.D_xy) && std::isfinite(s.theta) && std::isfinite(s.psi);
}

/// The last half of a half-turn, if Q hardly moved in it. A membrane that remembers its shape moves Q when it
/// turns so far.
std::optional<Samples> steady_part(Samples run) {
  constexpr double kHalfTurns = 0.5, kChange = 0.005;
  const auto part = last_turns(run, kHalfTurns);
  return part && hardly_moves(*part, kChange) ? part : std::nullopt;
}

/// Found on 96 boundary-integral runs of a biconcave capsule, each followed to kt = 90: all whose Q kept 0.06
/// over two half-turns went on with the kind of motion they had. Where D_xy is small all along, a nearly
/// spherical capsule, half of its largest value is asked for instead: a steady D_xy of 0.03 is not a passage
/// through 0.
double required_distance(Samples samples) {
  constexpr double kClear = 0.06;
  return std::min(kClear, std::ranges::max_element(samples, {}, &MotionSample::D_xy)->D_xy / 2);
}

}  // namespace

std::optional<Findings> look_at(Samples samples) {
  const Samples run = after_start(samples);
  if (run.empty() || !std::ranges::all_of(run, is_finite)) return std::nullopt;
  Findings found{
      .run = run, .judged = run, .half_turns = half_turns_from_end(run), .shares = shares_of_half_turns(run)};
  found.of_last_kind = half_turns_of_last_kind(found.half_turns);
  found.settled = found.of_last_kind >= kSettled;
  if (found.settled) found.judged = last_turns(run, kSettled).value_or(run);
  if (const auto steady = steady_part(run)) {
    found.steady = true;
    found.judged = *steady;
  }
  found.r = share_of_shape(found.judged);
  found.D_min = smallest_distance_to_origin(found.judged);
  found.required = required_distance(found.judged);
  return found;
}

}  // namespace capstan
