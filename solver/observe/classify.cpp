#include "solver/observe/classify.hpp"

#include <algorithm>
#include <cmath>

#include "solver/observe/explain.hpp"
#include "solver/observe/findings.hpp"
#include "solver/observe/shape_vector.hpp"

namespace capstan {
namespace {

Motion motion_of(const Findings& found) {
  const Motion turning = found.r >= kOfShape ? Motion::tumbling : Motion::tank_treading;
  if (found.steady || found.settled) return turning;
  if (found.half_turns.empty()) return Motion::undecided;
  if (found.turned_both() || found.shares.are_of_both_kinds() || found.came_near_round())
    return Motion::transition;
  return turning;
}

// ------------------------------------------------------------------------------------------ doubt

double from_0_to_1(double number) { return std::clamp(number, 0.0, 1.0); }

/// Distance of r to the nearer threshold.
double distance_of_r(double r) {
  return from_0_to_1(std::min(std::abs(r - kOfMembrane), std::abs(r - kOfShape)) / (1 - kOfShape));
}

double distance_of_kinds(const Shares& shares) {
  return from_0_to_1(std::min(shares.largest - kOfShape, kOfMembrane - shares.smallest) / (1 - kOfShape));
}

double margin_of_transition(const Findings& found) {
  const double mixed = found.turned_both() ? distance_of_r(found.r) : 0;
  const double near_round = from_0_to_1(1 - found.clearance());
  const double seen = double(found.half_turns.size()) / kSettled;
  const double missing = 1 - double(found.of_last_kind) / kSettled;
  return std::min({std::max({mixed, distance_of_kinds(found.shares), near_round}), seen, missing});
}

double margin_of(Motion motion, const Findings& found) {
  if (motion == Motion::undecided) return 0;
  if (motion == Motion::transition) return margin_of_transition(found);
  const double threshold = found.steady || found.settled ? 0 : 1;
  return std::min(distance_of_r(found.r), from_0_to_1(found.clearance() - threshold));
}

/// Whether Q keeps its distance from 0 for ever, as far as the last two half-turns tell: an approach to 0 is
/// slow, of 0.03 a half-turn in an oblate capsule of V = 15 that tumbles seven times and then tank-treads.
bool keeps_clear(const std::vector<Samples>& half_turns, double required) {
  constexpr double kAhead = 8;  // half-turns
  const double last = smallest_distance_to_origin(half_turns[0]);
  const double before = smallest_distance_to_origin(half_turns[1]);
  return last - kAhead * std::max(0., before - last) >= required;
}

/// After one half-turn Q must be far from 0, and the half-turn wholly of one kind: otherwise shape and
/// membrane shift against each other. After two they tell, as seen now and as seen half of a half-turn ago:
/// an approach to 0 may lie where two half-turns meet.
bool will_keep_clear(const Findings& found) {
  constexpr double kFar = 4, kWholly = 0.9;
  if (found.half_turns.size() < 2) return found.clearance() >= kFar && distance_of_r(found.r) >= kWholly;
  const size_t since = last_turns(found.run, 0.5).value_or(found.run).size() - 1;
  const auto earlier = half_turns_from_end(found.run.first(found.run.size() - since));
  return keeps_clear(found.half_turns, found.required) &&
         (earlier.size() < 2 || keeps_clear(earlier, found.required));
}

bool is_certain(Motion motion, const Findings& found) {
  constexpr double kClearOfR = 0.5;
  if (found.steady) return true;
  if (motion != Motion::tumbling && motion != Motion::tank_treading) return false;
  return distance_of_r(found.r) >= kClearOfR && found.clearance() >= 1 && will_keep_clear(found);
}

Evidence evidence_of(Motion motion, const Findings& found) {
  Evidence evidence;
  evidence.n_theta = shape_turns(found.run);
  evidence.n_psi = membrane_turns(found.run);
  evidence.turns = turns(found.run);
  evidence.r = found.r;
  evidence.D_min = found.D_min;
  evidence.theta_range = theta_range(found.half_turns.empty() ? found.run : found.half_turns.front());
  evidence.margin = margin_of(motion, found);
  return evidence;
}

}  // namespace

Verdict classify(Samples samples) {
  const std::optional<Findings> found = look_at(samples);
  Verdict verdict;
  if (!found) {
    verdict.explanation = explanation_of_none(samples);
    return verdict;
  }
  verdict.motion = motion_of(*found);
  verdict.evidence = evidence_of(verdict.motion, *found);
  verdict.certain = is_certain(verdict.motion, *found);
  verdict.steady = found->steady;
  verdict.explanation = explanation(verdict.motion, *found);
  return verdict;
}

}  // namespace capstan
