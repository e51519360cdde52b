// A thin sheet of incompressible rubber, per unit E_s (E_s = 3 G, paper eq. 27):
//   W = 1/6 [ λ1² + λ2² + 1/(λ1² λ2²) − 3 ]
//   dW/dλ1 = 1/3 [ λ1 − 1/(λ1³ λ2²) ],  and the same with 1 and 2 exchanged.
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

Eigen::ArrayXd energy(const Principal& stretches, const LawConstants&) {
  const auto square1 = stretches.col(0).square(), square2 = stretches.col(1).square();
  return (square1 + square2 + (square1 * square2).inverse() - 3) / 6;
}

Principal derivatives(const Principal& stretches, const LawConstants&) {
  const Eigen::ArrayXd thickness_squared = (stretches.col(0) * stretches.col(1)).square().inverse();
  return (stretches - stretches.inverse().colwise() * thickness_squared) / 3;
}

}  // namespace

StrainLaw neo_hookean() {
  return {.name = "neo-hookean",
          .modulus = "E_s = 3 G",
          .constants = {},
          .moduli =
              [](const LawConstants&) {
                return SmallStrainModuli{1. / 3, 1};
              },
          .energy = energy,
          .derivatives = derivatives};
}

}  // namespace capstan
