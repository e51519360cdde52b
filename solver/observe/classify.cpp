#include "solver/observe/classify.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace capstan {
namespace {

using std::numbers::pi;
using Records = std::span<const Record>;

constexpr double kStart = 3;                                   ///< kt
constexpr double kMostlyMembrane = 0.25, kMostlyShape = 0.75;  ///< thresholds of r

/// Thresholds of D_min, found on 96 boundary-integral runs of a biconcave capsule, each followed to kt = 60.
/// Q must keep this far from 0. Where D_xy is small all along, a nearly spherical capsule, half of its
/// largest value is asked for instead: a steady D_xy of 0.03 is not a passage through 0.
constexpr double kClear = 0.06;
/// No label given after one half-turn changed later if Q had kept this far away; nearer to 0 some did.
constexpr double kClearAfterOneTurn = 0.1;

Eigen::Vector2d shape_vector(const Record& record) {
  return record.D_xy * Eigen::Vector2d(std::cos(2 * record.theta), std::sin(2 * record.theta));
}

double distance_of_segment_to_origin(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  if (along.squaredNorm() == 0) return a.norm();
  return (a + std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm();
}

double smallest_distance_to_origin(Records records) {
  double smallest = shape_vector(records.front()).norm();
  for (size_t n = 0; n + 1 < records.size(); ++n)
    smallest = std::min(
        smallest, distance_of_segment_to_origin(shape_vector(records[n]), shape_vector(records[n + 1])));
  return smallest;
}

double shape_turns(Records records) { return (records.front().theta - records.back().theta) / pi; }
double membrane_turns(Records records) { return (records.front().psi - records.back().psi) / pi; }
double turns(Records records) { return shape_turns(records) + membrane_turns(records); }

/// The part of the history that counts.
Records after_start(const History& history) {
  constexpr double kRounding = 1e-9;  // kt is a sum of steps
  const auto first =
      std::ranges::find_if(history, [](const Record& r) { return r.kt >= kStart - kRounding; });
  return {first, history.end()};
}

/// The records cut where shape and membrane together have turned by another pi, without the unfinished rest.
std::vector<Records> half_turns(Records records) {
  std::vector<Records> pieces;
  for (size_t begin = 0, end = 1; end < records.size(); ++end) {
    const Records piece = records.subspan(begin, end - begin + 1);
    const double done = turns(records.first(end + 1));
    if (done < static_cast<double>(pieces.size()) + 1) continue;
    pieces.push_back(piece);
    begin = end;
  }
  return pieces;
}

double theta_range(Records records) {
  const auto [low, high] =
      std::ranges::minmax_element(records, {}, [](const Record& record) { return record.theta; });
  return high->theta - low->theta;
}

/// The records of the last half-turn, which need not begin where one of half_turns does.
Records last_half_turn(Records records) {
  size_t begin = records.size() - 1;
  while (begin > 0 && turns(records.subspan(begin)) < 1) --begin;
  return records.subspan(begin);
}

/// Whether some half-turns were of the shape and others of the membrane, and by how much: the smaller excess
/// over an equal share. Negative when all are of one kind.
double difference_in_kind(Records records) {
  double most = 0, least = 1;
  for (const Records& piece : half_turns(records)) {
    const double share = shape_turns(piece) / turns(piece);
    most = std::max(most, share);
    least = std::min(least, share);
  }
  return std::min(most - 0.5, 0.5 - least);
}

double required_distance(Records records) {
  const auto largest = std::ranges::max_element(records, {}, &Record::D_xy);
  return std::min(kClear, largest->D_xy / 2);
}

Evidence gather(Records records) {
  Evidence evidence;
  evidence.n_theta = shape_turns(records);
  evidence.n_psi = membrane_turns(records);
  evidence.turns = evidence.n_theta + evidence.n_psi;
  if (evidence.turns > 0) evidence.r = evidence.n_theta / evidence.turns;
  evidence.D_min = smallest_distance_to_origin(records);
  evidence.theta_range = theta_range(last_half_turn(records));
  return evidence;
}

}  // namespace

std::string_view word(Motion motion) {
  switch (motion) {
    case Motion::tumbling:
      return "tumbling";
    case Motion::tank_treading:
      return "tank_treading";
    case Motion::transition:
      return "transition";
    case Motion::undecided:
      break;
  }
  return "undecided";
}

Verdict classify(const History& history) {
  const Records records = after_start(history);
  if (records.empty()) return {};
  Verdict verdict{Motion::undecided, gather(records), false};
  Evidence& e = verdict.evidence;
  if (!(e.turns >= 1)) return verdict;

  const double clearance = e.D_min - required_distance(records);
  const double mixed_turns = std::min(e.r - kMostlyMembrane, kMostlyShape - e.r);
  const double mixed_kinds = difference_in_kind(records);
  if (mixed_turns > 0 || mixed_kinds > 0 || clearance < 0) {
    verdict.motion = Motion::transition;
    e.margin = std::max({mixed_turns, mixed_kinds, -clearance});
    return verdict;
  }
  verdict.motion = e.r >= kMostlyShape ? Motion::tumbling : Motion::tank_treading;
  e.margin = std::min(-mixed_turns, clearance);
  const bool far_from_round = e.D_min > kClearAfterOneTurn / kClear * required_distance(records);
  verdict.certain = far_from_round || e.turns >= 2;
  return verdict;
}

}  // namespace capstan
