#pragma once
// Synthetic phase diagrams: a known score over Ca and V, from which points follow as a run would report them.
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "runner/boundary/row.hpp"

namespace capstan {

struct SyntheticMap {
  std::string kind;
  std::function<double(double Ca, double V)> score;  ///< exact
  double noise = 0;                                  ///< largest error of the score of a point
  double share_failed = 0;                           ///< of the points that have no label
};

/// The same number for the same place, evenly distributed from 0 to 1.
inline double random_at(double Ca, double V, unsigned salt) {
  const std::size_t seed = std::hash<double>()(Ca) ^ (std::hash<double>()(V) << 1) ^ salt;
  std::mt19937_64 generator(seed);
  return std::uniform_real_distribution<double>(0, 1)(generator);
}

/// A point as a run reports it: its score is wrong by less than the error that it states.
inline RowPoint computed_point(const SyntheticMap& map, double Ca, double V) {
  constexpr double kLeastError = 0.01;
  RowPoint point;
  point.value = Ca;
  point.has_ended = true;
  if (random_at(Ca, V, 1) < map.share_failed) return point;
  const double score = map.score(Ca, V) + map.noise * (2 * random_at(Ca, V, 2) - 1);
  point.D_min = std::abs(score);
  point.r = score > 0 ? 1 : 0;
  point.error = kLeastError + map.noise;
  point.motion = score >= kNearRound    ? Motion::tumbling
                 : score <= -kNearRound ? Motion::tank_treading
                                        : Motion::transition;
  point.is_confirmed = std::abs(point.D_min - kNearRound) > point.error;
  return point;
}

}  // namespace capstan
