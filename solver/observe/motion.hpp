#pragma once
// The kinds of motion of a capsule: the labels that result.json, the database and the API give to a run, and
// the thresholds between them.
#include "solver/case/words.hpp"

namespace capstan {

/// Decided by classify().
enum class Motion {
  tumbling,       ///< the shape turns like a rigid body
  tank_treading,  ///< the shape keeps its angle while the membrane turns around it
  transition,     ///< between the two
  undecided,      ///< less than one half-turn was computed, or the mesh did not resolve the surface
};
/// The words of result.json.
template <>
inline constexpr auto kWords<Motion> = std::to_array<Word<Motion>>({{Motion::tumbling, "tumbling"},
                                                                    {Motion::tank_treading, "tank_treading"},
                                                                    {Motion::transition, "transition"},
                                                                    {Motion::undecided, "undecided"}});

// The thresholds of the rules (classify.hpp).

/// A half-turn is of the membrane if the share of the shape in it is at most kOfMembrane, and of the shape if
/// it is at least kOfShape. Between the two it is of neither kind.
inline constexpr double kOfMembrane = 0.25, kOfShape = 0.75;

/// A motion that has not settled is a transition if |Q| falls below this. In 96 boundary-integral runs of a
/// biconcave capsule, each computed to kt = 90, every run that kept |Q| above it over two half-turns
/// continued its kind of motion.
inline constexpr double kNearRound = 0.06;

}  // namespace capstan
