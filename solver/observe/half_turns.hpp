#pragma once
// Half-turns of a capsule: in one of them the angles of shape and membrane together change by pi. The share
// of the shape in that change is near 1 for tumbling and near 0 for tank-treading. Turns are positive
// clockwise, as the shear flow turns. All functions require at least one sample.
#include <optional>
#include <vector>

#include "solver/observe/motion.hpp"
#include "solver/observe/motion_sample.hpp"

namespace capstan {

double shape_turns(Samples samples);     ///< -(change of theta) / pi
double membrane_turns(Samples samples);  ///< -(change of psi) / pi
double turns(Samples samples);           ///< shape_turns + membrane_turns
double share_of_shape(Samples samples);  ///< shape_turns / turns; 0 where turns <= 0
double theta_range(Samples samples);     ///< largest minus smallest theta, radians

/// The shortest part at the end that has this number of half-turns; nothing if the samples have fewer.
std::optional<Samples> last_turns(Samples samples, double half_turns);

/// The run divided into half-turns, counted back from its end; the last one is first. The rest at the start,
/// less than a half-turn, is not included.
std::vector<Samples> half_turns_from_end(Samples samples);

/// Number of consecutive half-turns at the end of the same kind as the last one; 0 if the last one is of
/// neither kind.
/// \param half_turns  the last one first
int half_turns_of_last_kind(const std::vector<Samples>& half_turns);

/// Smallest and largest share of the shape in one half-turn, over all half-turns that end at a sample.
struct Shares {
  double smallest = 1, largest = 0;

  bool are_of_both_kinds() const { return smallest <= kOfMembrane && largest >= kOfShape; }
};
Shares shares_of_half_turns(Samples samples);

}  // namespace capstan
