#pragma once
// Generalised minimal residuals (Saad and Schultz 1986) for an operator that is only known by what it does to
// a vector. Eigen's own GMRES measures its tolerance against the first residual, which a good start makes
// small.
#include <Eigen/Dense>
#include <functional>

namespace capstan {

struct LinearSolution {
  int products = 0;           ///< of the operator with a vector
  double relative_error = 0;  ///< |b - A x| / |b|
};

/// Solves A x = b to |b - A x| <= tolerance |b|, or as far as `most_products` reach.
/// \param x the first guess in, the solution out
LinearSolution solve_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                           const Eigen::VectorXd& b, double tolerance, int most_products, Eigen::VectorXd& x);

}  // namespace capstan
