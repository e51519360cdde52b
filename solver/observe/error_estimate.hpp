#pragma once
// The error of a run, estimated from its distance to the same run at the rung below of the ladder
// (ladder.hpp).
#include "solver/case/case.hpp"
#include "solver/observe/distance.hpp"
#include "solver/observe/motion.hpp"

namespace capstan {

/// Errors against the limit of fine resolution, in the meaning of Distance. NaN where unknown.
struct ErrorEstimate {
  double Q, D_xy, theta, period;
};

/// A run whose error is estimated.
struct EstimatedRun {
  Case parameters;
  double kt = 0;                ///< its end
  double half_turns = 0;        ///< from kt = 3 on
  double largest_dihedral = 0;  ///< degrees between the normals of neighbouring triangles, over the whole run
};

/// The distance to the companion times a factor, and not less than a smallest error. Both were calibrated for
/// each flow model and rung on random scenes, so that at least 95 % of the true errors are smaller
/// (studies/calibration). If the companion ended earlier than the run, the error is taken to grow in
/// proportion to time.
///
/// Deformation, angle and period of two rungs may agree by chance where Q does not: their errors are taken
/// from Q, too.
ErrorEstimate estimated_error(const EstimatedRun& run, const Distance& to_companion);

/// A label that can be relied upon: the companion has the same one, and the error is less than the one that
/// the label tolerates. \param margin  of the evidence (classify.hpp)
bool is_confirmed(Motion motion, double margin, Motion of_companion, const ErrorEstimate& error);

}  // namespace capstan
