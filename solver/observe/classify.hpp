#pragma once
// The motion of a run: tumbling, tank-treading, or a transition between the two. Valid for motion in the
// plane of shear.
//
// Let Q = D_xy (cos 2 theta, sin 2 theta), the in-plane shape vector. A capsule tumbles when Q winds around
// 0. It tank-treads when Q does not and the membrane turns. At the boundary between the two, Q passes through
// 0: the section is circular for a moment and theta may continue on either branch. The label is therefore not
// determined from theta alone: the rotation of the shape is compared with that of the membrane, and the
// smallest distance of Q to 0 is tested.
//
// In one half-turn the angles of shape and membrane together change by pi. The share of the shape in that
// change is near 1 for tumbling and near 0 for tank-treading: these are the two kinds of half-turns. The
// first rule that applies decides:
//   1. The shape is steady while the membrane turns: tank-treading.
//   2. The last three half-turns are of one kind: the motion has settled and has that kind. Earlier motion
//      and the distance of Q to 0 do not count.
//   3. Less than one half-turn was computed: undecided.
//   4. Half-turns of both kinds occurred; or the share r of the shape in all of them lies between the
//      thresholds of the two kinds; or Q came nearer to 0 than min(0.06, D_max / 2), D_max the largest D_xy:
//      transition.
//   5. Otherwise tumbling if r is above the upper threshold, tank-treading if it is below the lower one.
#include <string>

#include "solver/observe/motion.hpp"
#include "solver/observe/motion_sample.hpp"

namespace capstan {

/// Counted from kt = 3 on: earlier motion depends on the start. Half-turns are positive clockwise, as the
/// shear flow turns. r, D_min and margin refer to the part that was judged: the last half of a half-turn
/// under rule 1, the last three half-turns under rule 2, otherwise the whole run.
struct Evidence {
  double n_theta = 0;      ///< half-turns of the shape: -(change of theta) / pi
  double n_psi = 0;        ///< half-turns of the membrane against the shape: -(change of psi) / pi
  double turns = 0;        ///< n_theta + n_psi
  double r = 0;            ///< share of the shape: 1 for a rigid body, 0 for pure tank-treading
  double D_min = 0;        ///< smallest distance to 0 of the segments between successive Q
  double theta_range = 0;  ///< largest minus smallest theta over the last half-turn, radians

  /// The error of Q that the label tolerates, in the units of D_xy: a smaller one cannot change the label.
  /// For tumbling and tank-treading the smaller one of two: the distance of D_min to the one that rule 4
  /// requires (to 0 once the motion has settled), and the error that would move r to its threshold; D_min for
  /// a steady shape. For a transition the largest among the reasons of rule 4, times n/3 and m/3 at most,
  /// where n is the number of half-turns and m the number of further half-turns of one kind that rule 2
  /// requires. For undecided 0.
  double margin = 0;
};

struct Verdict {
  Motion motion = Motion::undecided;
  Evidence evidence;
  bool certain = false;     ///< a longer run would not change the label, so the run may end
  bool steady = false;      ///< rule 1
  std::string explanation;  ///< a sentence: the reason for the label, or for its absence
};

/// \param samples in the order of time, so close that Q moves little from one to the next
Verdict classify(Samples samples);

}  // namespace capstan
