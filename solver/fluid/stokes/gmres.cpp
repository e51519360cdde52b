#include "solver/fluid/stokes/gmres.hpp"

#include <vector>

namespace capstan {

LinearSolution solve_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                           const Eigen::VectorXd& b, double tolerance, int max_products, Eigen::VectorXd& x) {
  LinearSolution solution{.products = 1, .relative_error = 0, .residual = b - apply(x)};
  const double beta = solution.residual.norm(), wanted = tolerance * b.norm();
  solution.relative_error = beta / b.norm();
  if (!(beta > wanted)) return solution;  // converged, or not a number

  std::vector<Eigen::VectorXd> basis{solution.residual / beta};
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(max_products + 1, max_products);
  Eigen::VectorXd coefficients, left;  // left: the residual in the basis
  for (int k = 0; solution.products < max_products; ++k) {
    Eigen::VectorXd next = apply(basis[k]);  // Arnoldi: A times the last vector, orthogonalised
    ++solution.products;
    for (int j = 0; j <= k; ++j) {
      hessenberg(j, k) = basis[j].dot(next);
      next -= hessenberg(j, k) * basis[j];
    }
    hessenberg(k + 1, k) = next.norm();

    const auto small = hessenberg.topLeftCorner(k + 2, k + 1);
    const Eigen::VectorXd first = beta * Eigen::VectorXd::Unit(k + 2, 0);
    coefficients = small.householderQr().solve(first);
    left = first - small * coefficients;
    solution.relative_error = left.norm() / b.norm();
    if (hessenberg(k + 1, k) == 0) break;
    basis.push_back(next / hessenberg(k + 1, k));
    if (!(left.norm() > wanted)) break;
  }
  for (Eigen::Index j = 0; j < coefficients.size(); ++j) x += coefficients[j] * basis[j];
  solution.residual.setZero();
  for (size_t j = 0; j < basis.size(); ++j) solution.residual += left[j] * basis[j];
  return solution;
}

}  // namespace capstan
