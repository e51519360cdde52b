#pragma once
// The kinds of motion of a capsule: the labels that result.json, the database and the API give to a run.
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

}  // namespace capstan
