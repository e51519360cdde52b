#pragma once
// The kinds of motion of a capsule: the labels that result.json, the database and the API give to a run.
#include <array>
#include <optional>
#include <string_view>

namespace capstan {

enum class Motion {
  tumbling,       ///< the shape turns like a rigid body
  tank_treading,  ///< the shape keeps its angle while the membrane turns around it
  transition,     ///< between the two
  undecided,      ///< less than one half-turn was seen, or the mesh could not represent the surface
};

inline constexpr std::array kMotions = {Motion::tumbling, Motion::tank_treading, Motion::transition,
                                        Motion::undecided};

/// The word of result.json, for example "tank_treading".
std::string_view to_string(Motion motion);
/// Nothing if `word` is none of the four words.
std::optional<Motion> parse_motion(std::string_view word);

}  // namespace capstan
