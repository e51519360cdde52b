#pragma once
// The kinds of motion of a capsule: the labels that result.json, the database and the API give to a run.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace capstan {

/// Decided by classify().
enum class Motion {
  tumbling,       ///< the shape turns like a rigid body
  tank_treading,  ///< the shape keeps its angle while the membrane turns around it
  transition,     ///< between the two
  undecided,      ///< less than one half-turn was computed, or the mesh did not resolve the surface
};

inline constexpr std::array kMotions = {Motion::tumbling, Motion::tank_treading, Motion::transition,
                                        Motion::undecided};

/// The word of result.json, for example "tank_treading".
constexpr std::string_view to_string(Motion motion) {
  constexpr std::array<std::string_view, kMotions.size()> kWords = {"tumbling", "tank_treading", "transition",
                                                                    "undecided"};
  return kWords[static_cast<std::size_t>(motion)];
}

/// Nothing if `word` is none of the four words.
constexpr std::optional<Motion> parse_motion(std::string_view word) {
  const auto found = std::ranges::find(kMotions, word, [](Motion motion) { return to_string(motion); });
  return found == kMotions.end() ? std::nullopt : std::optional(*found);
}

}  // namespace capstan
