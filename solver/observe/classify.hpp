#pragma once
// What a run was: tumbling, tank-treading, or between the two.
//
// Let Q = D (cos 2 theta, sin 2 theta), the in-plane shape vector. A capsule tumbles when Q winds around 0;
// it tank-treads when Q does not, while the membrane turns. On the boundary the curve passes through 0: the
// section is round for a moment, and theta alone may take either branch. The label therefore weighs the
// turning of the shape against that of the membrane and asks how near Q came to 0. It is a label for motion
// in the plane of shear.
//
// Shape and membrane together turn by pi in one half-turn. The share of the shape in it is near 1 where the
// capsule tumbles and near 0 where it tank-treads: these are the two kinds of half-turns. The rules, in their
// order:
//   1. The shape is steady while the membrane turns: tank-treading.
//   2. The last three half-turns are of one kind: the motion has settled, the label is that kind. Neither how
//      near Q came to 0 nor an earlier motion counts.
//   3. Less than one half-turn was seen: undecided.
//   4. Half-turns were of both kinds, or the share r of the shape in all of them lies between those of the
//   two
//      kinds, or Q came nearer to 0 than min(0.06, D_max / 2), D_max the largest D: transition.
//   5. Otherwise the kind that r says.
#include <string>

#include "solver/observe/motion_sample.hpp"
#include "solver/run_directory/motion.hpp"

namespace capstan {

/// Counted from kt = 3 on, when the start is forgotten. Half-turns are clockwise, as the shear turns. r,
/// D_min and margin are of the part that was judged: under rule 1 the last half of a half-turn, under rule 2
/// the last three half-turns, else everything.
struct Evidence {
  double n_theta = 0;      ///< half-turns of the shape: -(change of theta) / pi
  double n_psi = 0;        ///< half-turns of the membrane against the shape: -(change of psi) / pi
  double turns = 0;        ///< n_theta + n_psi
  double r = 0;            ///< share of the shape: 1 for a rigid body, 0 for pure tank-treading
  double D_min = 0;        ///< smallest distance of the segments between successive Q to 0
  double theta_range = 0;  ///< largest minus smallest theta over the last half-turn

  /// How far the evidence is from that for another label: from 0, doubtful, to 1, clear. Distances of r are
  /// measured in 0.25, those of D_min in the distance that rule 4 asks for. Tumbling and tank-treading: the
  /// smaller of the distances of r and of D_min to their thresholds; that of D_min is 0 once the motion has
  /// settled. Transition: the largest distance among its reasons, but no more than the share of three
  /// half-turns that was seen, nor than the share that is missing for rule 2. Undecided: 0.
  double margin = 0;
};

struct Verdict {
  Motion motion = Motion::undecided;
  Evidence evidence;
  bool certain = false;     ///< more time would not change the label: a run may end here
  bool steady = false;      ///< rule 1
  std::string explanation;  ///< a sentence: why this label, or what is missing for one
};

/// \param samples in the order of time, close enough for Q to move little from one to the next
Verdict classify(Samples samples);

}  // namespace capstan
