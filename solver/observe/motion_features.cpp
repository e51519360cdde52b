#include "solver/observe/motion_features.hpp"

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

/// The last half of a half-turn, if Q hardly moved in it; nothing otherwise. Half of a half-turn suffices to
/// judge: with shape memory, where the shape depends on the orientation of the membrane, Q would have changed
/// by then.
std::optional<Samples> steady_part(Samples run) {
  constexpr double kHalfTurns = 0.5, kChange = 0.005;
  const auto part = last_turns(run, kHalfTurns);
  return part && hardly_moves(*part, kChange) ? part : std::nullopt;
}

/// Distance of Q to 0 that rule 4 requires: min(kNearRound, D_max / 2). For a nearly spherical capsule, whose
/// D_xy is small at all times, D_max / 2 is the smaller number.
double required_distance(Samples samples) {
  return std::min(kNearRound, std::ranges::max_element(samples, {}, &MotionSample::D_xy)->D_xy / 2);
}

}  // namespace

std::optional<MotionFeatures> motion_features(Samples samples) {
  const Samples run = after_start(samples);
  if (run.empty() || !std::ranges::all_of(run, is_finite)) return std::nullopt;
  MotionFeatures features{
      .run = run, .judged = run, .half_turns = half_turns_from_end(run), .shares = shares_of_half_turns(run)};
  features.of_last_kind = half_turns_of_last_kind(features.half_turns);
  features.settled = features.of_last_kind >= kSettled;
  if (features.settled) features.judged = last_turns(run, kSettled).value_or(run);
  if (const auto steady = steady_part(run)) {
    features.steady = true;
    features.judged = *steady;
  }
  features.r = share_of_shape(features.judged);
  features.D_min = smallest_distance_to_origin(features.judged);
  features.required = required_distance(features.judged);
  return features;
}

}  // namespace capstan
