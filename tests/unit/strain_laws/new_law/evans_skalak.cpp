// The membrane of a red blood cell after Evans and Skalak (1980), per unit E_s (E_s = 2 G):
//   W = K/2 (J − 1)² + 1/2 [ (λ1² + λ2²) / (2 J) − 1 ],   J = λ1 λ2
//   dW/dλ1 = K (J − 1) λ2 + 1/4 [ 1/λ2 − λ2/λ1² ],  and the same with 1 and 2 exchanged.
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {
namespace {

Eigen::ArrayXd energy(const Principal& stretches, const LawConstants& constants) {
  const double K = constants[0];
  const Eigen::ArrayXd J = stretches.col(0) * stretches.col(1);
  return K / 2 * (J - 1).square() + 0.5 * (stretches.square().rowwise().sum() / (2 * J) - 1);
}

Principal derivatives(const Principal& stretches, const LawConstants& constants) {
  const double K = constants[0];
  const Principal other = stretches.rowwise().reverse();
  const Eigen::ArrayXd dilation = K * (stretches.col(0) * stretches.col(1) - 1);
  return other.colwise() * dilation + 0.25 * (other.inverse() - other / stretches.square());
}

}  // namespace

StrainLaw evans_skalak() {
  return {.name = "evans-skalak",
          .modulus = "E_s = 2 G",
          .constants = {{"K", "the area modulus over E_s", 0.1, 1000}},
          .moduli =
              [](const LawConstants& constants) {
                return SmallStrainModuli{0.5, constants[0]};
              },
          .energy = energy,
          .derivatives = derivatives};
}

}  // namespace capstan
