#pragma once
// The error of a run, estimated from its distance to a run of the same case at a coarser rung of the ladder
// (ladder.hpp): at twice the spacing, its companion, or at the next rung.
#include "solver/case/case.hpp"
#include "solver/observe/distance.hpp"
#include "solver/observe/motion.hpp"

namespace capstan {

/// Errors against the limit of fine resolution, in the meaning of Distance. NaN where unknown.
struct ErrorEstimate {
  double Q, D_xy, theta, period;
};

/// A run whose error is estimated, or the coarser one that it is compared to.
struct EstimatedRun {
  Case parameters;
  double kt = 0;                ///< its end
  double half_turns = 0;        ///< from kt = 3 on
  double largest_dihedral = 0;  ///< degrees between the normals of neighbouring triangles, over the whole run
};

/// If the error is proportional to h^p, the run with the spacing rho h is at the distance (rho^p - 1) times
/// the error of the run with h; p = 2 for boundary integrals, 1 for lattices. The estimate is the error that
/// follows, times a factor, and not less than a smallest error. Both were calibrated for each flow model and
/// rung on random scenes, so that at least 95 % of the true errors are smaller (studies/calibration). Two
/// neighbouring rungs of boundary integrals need smaller factors, since the errors of two runs with nearly
/// equal spacings are nearly proportional to each other. If the coarser run ended earlier, the error is taken
/// to grow in proportion to time.
///
/// On a finer mesh the angles between neighbouring triangles of a smooth surface are smaller. They are not
/// where a membrane without bending stiffness has wrinkles as narrow as the mesh allows. Its motion then does
/// not converge, and the estimate is at least 0.2, or 0.02 for a sphere.
///
/// Deformation, angle and period of two rungs may agree by chance where Q does not: their errors are taken
/// from Q, too.
/// \param distance  of the two runs
ErrorEstimate estimated_error(const EstimatedRun& run, const EstimatedRun& coarser, const Distance& distance);

/// A label that can be relied upon: the coarser run has the same one, and the error is less than the one that
/// the label tolerates. \param margin  of the evidence (classify.hpp)
bool is_confirmed(Motion motion, double margin, Motion of_coarser, const ErrorEstimate& error);

}  // namespace capstan
