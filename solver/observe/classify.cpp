#include "solver/observe/classify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/observe/explain.hpp"
#include "solver/observe/motion_features.hpp"
#include "solver/observe/shape_vector.hpp"

namespace capstan {
namespace {

Motion motion_of(const MotionFeatures& features) {
  const Motion turning = features.r >= kOfShape ? Motion::tumbling : Motion::tank_treading;
  if (features.steady || features.settled) return turning;
  if (features.half_turns.empty()) return Motion::undecided;
  if (features.turned_both() || features.shares.are_of_both_kinds() || features.came_near_round())
    return Motion::transition;
  return turning;
}

double clamped_to_unit(double number) { return std::clamp(number, 0.0, 1.0); }

/// Distance of r to the nearer one of kOfMembrane and kOfShape.
double distance_of_r(double r) { return std::min(std::abs(r - kOfMembrane), std::abs(r - kOfShape)); }

/// 0 unless half-turns of both kinds occurred. Then the distance of the extreme shares to their thresholds,
/// the smaller of the two.
double distance_of_kinds(const Shares& shares) {
  return std::max(0., std::min(shares.largest - kOfShape, kOfMembrane - shares.smallest));
}

/// The smallest error of Q that can change the share of the shape in a number of half-turns by `change`. An
/// error e turns Q by at most asin(e / |Q|) at each end of them, and theta by half of that.
double error_that_changes(double change, double half_turns, double D_min) {
  using std::numbers::pi;
  return D_min * std::sin(std::min(pi / 2, pi * half_turns * change));
}

double margin_of_transition(const MotionFeatures& features) {
  const double mixed = features.turned_both() ? error_that_changes(distance_of_r(features.r),
                                                                   turns(features.judged), features.D_min)
                                              : 0;
  const double of_both_kinds = error_that_changes(distance_of_kinds(features.shares), 1, features.D_min);
  const double near_round = std::max(0., features.required - features.D_min);
  const double seen = double(features.half_turns.size()) / kSettled;
  const double missing = 1 - double(features.of_last_kind) / kSettled;
  return std::max({mixed, of_both_kinds, near_round}) * clamped_to_unit(std::min(seen, missing));
}

double margin_of(Motion motion, const MotionFeatures& features) {
  if (motion == Motion::undecided) return 0;
  if (motion == Motion::transition) return margin_of_transition(features);
  if (features.steady) return features.D_min;
  const double clear_of_round = features.D_min - (features.settled ? 0 : features.required);
  return std::min(clear_of_round,
                  error_that_changes(distance_of_r(features.r), turns(features.judged), features.D_min));
}

/// Whether the smallest |Q| of a half-turn stays above `required` in the next half-turns, by linear
/// extrapolation from the last two. Q may approach 0 slowly: by 0.03 per half-turn for an oblate capsule (V =
/// 15) that tumbles seven times and then tank-treads.
/// \param half_turns  at least two, the last one first
bool keeps_clear(const std::vector<Samples>& half_turns, double required) {
  constexpr double kAhead = 8;  // half-turns
  const double last = smallest_distance_to_origin(half_turns[0]);
  const double before = smallest_distance_to_origin(half_turns[1]);
  return last - kAhead * std::max(0., before - last) >= required;
}

/// Whether Q will stay away from 0 if the run continues. After a single half-turn this is assumed if Q is far
/// from 0 and the half-turn is clearly of one kind. After two or more, Q is extrapolated twice: with
/// half-turns counted back from the end of the run, and from half a half-turn before the end, because Q may
/// be closest to 0 at the boundary between two half-turns.
bool will_keep_clear(const MotionFeatures& features) {
  constexpr double kFar = 4, kClearlyOneKind = 0.225;
  if (features.half_turns.size() < 2)
    return features.clearance() >= kFar && distance_of_r(features.r) >= kClearlyOneKind;
  const size_t since = last_turns(features.run, 0.5).value_or(features.run).size() - 1;
  const auto earlier = half_turns_from_end(features.run.first(features.run.size() - since));
  return keeps_clear(features.half_turns, features.required) &&
         (earlier.size() < 2 || keeps_clear(earlier, features.required));
}

bool is_certain(Motion motion, const MotionFeatures& features) {
  constexpr double kClearOfR = 0.125;
  if (features.steady) return true;
  if (motion != Motion::tumbling && motion != Motion::tank_treading) return false;
  return distance_of_r(features.r) >= kClearOfR && features.clearance() >= 1 && will_keep_clear(features);
}

Evidence evidence_of(Motion motion, const MotionFeatures& features) {
  Evidence evidence;
  evidence.n_theta = shape_turns(features.run);
  evidence.n_psi = membrane_turns(features.run);
  evidence.turns = turns(features.run);
  evidence.r = features.r;
  evidence.D_min = features.D_min;
  evidence.theta_range =
      theta_range(features.half_turns.empty() ? features.run : features.half_turns.front());
  evidence.margin = margin_of(motion, features);
  return evidence;
}

}  // namespace

Verdict classify(Samples samples) {
  const std::optional<MotionFeatures> features = motion_features(samples);
  Verdict verdict;
  if (!features) {
    verdict.explanation = explanation_without_features(samples);
    return verdict;
  }
  verdict.motion = motion_of(*features);
  verdict.evidence = evidence_of(verdict.motion, *features);
  verdict.certain = is_certain(verdict.motion, *features);
  verdict.steady = features->steady;
  verdict.explanation = explanation(verdict.motion, *features);
  return verdict;
}

}  // namespace capstan
