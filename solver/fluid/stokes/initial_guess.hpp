#pragma once
// Initial guesses for a sequence of linear equations A x = b whose operators and right-hand sides change
// little from one to the next: the boundary integral equation at successive positions of the membrane.
#include <Eigen/Dense>

#include "solver/state/state_archive.hpp"

namespace capstan {

/// The right-hand side is approximated by a linear combination of the last ones (least squares, as in the
/// projection of Fischer, Comput. Methods Appl. Mech. Eng. 163, 193, 1998), and the guess is the same
/// combination of their solutions. Right-hand sides that change smoothly in time are thereby extrapolated.
/// The rest of the right-hand side consists of short waves, for which A is nearly a number.
class InitialGuess {
 public:
  /// \param inverse  A^-1 for short waves
  explicit InitialGuess(double inverse) : inverse_(inverse) {}

  Eigen::VectorXd solution_of(const Eigen::VectorXd& right_side) const;
  void remember(const Eigen::VectorXd& right_side, const Eigen::VectorXd& solution);

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  double inverse_;
  Eigen::MatrixXd right_sides_, solutions_;  ///< one column for each of the last equations, the newest first
};

}  // namespace capstan
