#pragma once
// The generalised minimal residual method (GMRES, Saad and Schultz 1986), without restarts, for an operator
// given as a function. Eigen's own GMRES is not used: its tolerance is relative to the first residual, which
// is small where the initial guess is good.
#include <Eigen/Dense>
#include <functional>

namespace capstan {

struct LinearSolution {
  int products = 0;           ///< number of operator-vector products
  double relative_error = 0;  ///< |b - A x| / |b|
  Eigen::VectorXd residual;   ///< b - A x
};

/// Solves A x = b until |b - A x| <= tolerance |b|, or until `max_products` products were computed.
/// \param apply  computes A v from v
/// \param x      in: the initial guess; out: the solution
LinearSolution solve_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                           const Eigen::VectorXd& b, double tolerance, int max_products, Eigen::VectorXd& x);

}  // namespace capstan
