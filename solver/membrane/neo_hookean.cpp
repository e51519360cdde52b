#include "solver/membrane/neo_hookean.hpp"

namespace capstan {

Eigen::ArrayXd NeoHookean::energy(const Principal& stretches) const {
  const auto square1 = stretches.col(0).square(), square2 = stretches.col(1).square();
  return (square1 + square2 + (square1 * square2).inverse() - 3) / 6;
}

Principal NeoHookean::derivatives(const Principal& stretches) const {
  const Eigen::ArrayXd thinning =
      (stretches.col(0) * stretches.col(1)).square().inverse();  // thickness ratio squared
  return (stretches - stretches.inverse().colwise() * thinning) / 3;
}

}  // namespace capstan
