#include "solver/membrane/skalak.hpp"

namespace capstan {
namespace {

struct Invariants {
  Eigen::ArrayXd I1, I2;
};

Invariants invariants(const Principal& squares) {
  return {squares.col(0) + squares.col(1) - 2, squares.col(0) * squares.col(1) - 1};
}

}  // namespace

Eigen::ArrayXd Skalak::energy(const Principal& stretches) const {
  const auto [I1, I2] = invariants(stretches.square());
  return (I1.square() + 2 * I1 - 2 * I2 + C_ * I2.square()) / 8;
}

Principal Skalak::derivatives(const Principal& stretches) const {
  const Principal squares = stretches.square();
  const auto [I1, I2] = invariants(squares);
  const Eigen::ArrayXd shear = I1 + 1, dilation = C_ * I2 - 1;
  Principal dW = stretches / 2;
  dW.col(0) *= shear + squares.col(1) * dilation;
  dW.col(1) *= shear + squares.col(0) * dilation;
  return dW;
}

}  // namespace capstan
