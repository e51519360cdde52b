#include "solver/fluid/stokes/initial_guess.hpp"

#include <algorithm>

namespace capstan {
namespace {

// Red cell, Ca = 0.016, V = 4, tolerance 1e-3: 2.6, 1.8, 1.75 and 1.7 products a flow with 1, 2, 4 and 6
// remembered.
constexpr Eigen::Index kRemembered = 4;

/// Puts a column in front of the others, of which at most kRemembered - 1 are kept.
void put_in_front(Eigen::MatrixXd& columns, const Eigen::VectorXd& column) {
  const Eigen::Index kept = std::min(columns.cols(), kRemembered - 1);
  Eigen::MatrixXd all(column.size(), kept + 1);
  all.col(0) = column;
  if (kept > 0) all.rightCols(kept) = columns.leftCols(kept);
  columns = std::move(all);
}

void put_matrix(StateArchive& archive, const std::string& name, const Eigen::MatrixXd& matrix) {
  archive.put(name, std::vector<double>(matrix.data(), matrix.data() + matrix.size()));
}

Eigen::MatrixXd get_matrix(const StateArchive& archive, const std::string& name, Eigen::Index columns) {
  const auto data = archive.get(name);
  if (columns == 0) return {};
  return Eigen::Map<const Eigen::MatrixXd>(data.data(), Eigen::Index(data.size()) / columns, columns);
}

}  // namespace

Eigen::VectorXd InitialGuess::solution_of(const Eigen::VectorXd& right_side) const {
  if (right_sides_.cols() == 0) return inverse_ * right_side;
  // The right-hand sides are nearly parallel. Regularisation bounds the weights, which multiply the errors of
  // the solutions.
  constexpr double kRegularisation = 1e-10;
  Eigen::MatrixXd products = right_sides_.transpose() * right_sides_;
  products.diagonal() *= 1 + kRegularisation;
  const Eigen::VectorXd weights = products.ldlt().solve(right_sides_.transpose() * right_side);
  return solutions_ * weights + inverse_ * (right_side - right_sides_ * weights);
}

void InitialGuess::remember(const Eigen::VectorXd& right_side, const Eigen::VectorXd& solution) {
  put_in_front(right_sides_, right_side);
  put_in_front(solutions_, solution);
}

void InitialGuess::save(StateArchive& archive) const {
  archive.put("fluid/remembered", double(right_sides_.cols()));
  put_matrix(archive, "fluid/right_sides", right_sides_);
  put_matrix(archive, "fluid/solutions", solutions_);
}

void InitialGuess::load(const StateArchive& archive) {
  const auto columns = Eigen::Index(archive.number("fluid/remembered"));
  right_sides_ = get_matrix(archive, "fluid/right_sides", columns);
  solutions_ = get_matrix(archive, "fluid/solutions", columns);
}

}  // namespace capstan
