#pragma once
// How shape and membrane turn. Together they turn by pi in one half-turn; the share of the shape in it is
// near 1 where the capsule tumbles and near 0 where it tank-treads. Turning is counted clockwise, as the
// shear turns. Samples are never empty here.
#include <optional>
#include <vector>

#include "solver/observe/motion_sample.hpp"

namespace capstan {

/// Shares of the shape in a half-turn, at most and at least, that make it one of the membrane or of the
/// shape. Between them a half-turn is of no kind.
constexpr double kOfMembrane = 0.25, kOfShape = 0.75;

double shape_turns(Samples samples);     ///< -(change of theta) / pi
double membrane_turns(Samples samples);  ///< -(change of psi) / pi
double turns(Samples samples);           ///< of both together
double share_of_shape(Samples samples);  ///< 0 where nothing turned
double theta_range(Samples samples);     ///< largest minus smallest theta

/// The shortest part at the end in which shape and membrane make so many half-turns; nothing if they made
/// fewer.
std::optional<Samples> last_turns(Samples samples, double half_turns);

/// The last half-turn first. The rest at the start, less than a half-turn, is left out.
std::vector<Samples> half_turns_from_end(Samples samples);

/// How many of the last half-turns are of the same kind as the last one; 0 if that is of none.
/// \param half_turns the last one first
int half_turns_of_last_kind(const std::vector<Samples>& half_turns);

/// Smallest and largest share of the shape in a half-turn, wherever it begins.
struct Shares {
  double smallest = 1, largest = 0;

  /// Some half-turns were of the shape and others of the membrane.
  bool are_of_both_kinds() const { return smallest <= kOfMembrane && largest >= kOfShape; }
};
Shares shares_of_half_turns(Samples samples);

}  // namespace capstan
