#pragma once
// What a run was: tumbling, tank-treading, or between the two.
//
// Let Q = D (cos 2 theta, sin 2 theta), the in-plane shape vector. A capsule tumbles when Q winds around 0;
// it tank-treads when Q does not, while the membrane turns. On the boundary the curve passes through 0: the
// section is round for a moment, and theta alone may take either branch. The label therefore weighs the
// turning of the shape against that of the membrane and asks how near Q came to 0. It is a label for motion
// in the plane of shear.
#include <string_view>

#include "solver/observe/history.hpp"

namespace capstan {

enum class Motion {
  tumbling,
  tank_treading,
  transition,  ///< between the two: Q came near 0, or shape and membrane both turned
  undecided,   ///< less than one half-turn was seen
};
std::string_view word(Motion motion);

/// Counted from kt = 3 on, when the start is forgotten. Half-turns are clockwise, as the shear turns.
struct Evidence {
  double n_theta = 0;      ///< half-turns of the shape: -(change of theta) / pi
  double n_psi = 0;        ///< half-turns of the membrane against the shape: -(change of psi) / pi
  double r = 0;            ///< n_theta / (n_theta + n_psi): 1 for a rigid body, 0 for pure tank-treading
  double D_min = 0;        ///< smallest distance of the segments between successive Q to 0
  double turns = 0;        ///< n_theta + n_psi
  double theta_range = 0;  ///< largest minus smallest theta over the last half-turn

  /// How far the label is from another one, >= 0. Tumbling, tank-treading: the smaller of the distances of r
  /// to its threshold and of D_min to the one it must keep. Transition: the largest distance among the
  /// reasons for it.
  double margin = 0;
};

struct Verdict {
  Motion motion = Motion::undecided;
  Evidence evidence;
  bool certain = false;  ///< more time would not change the label: a run may end here
};

Verdict classify(const History& history);

}  // namespace capstan
