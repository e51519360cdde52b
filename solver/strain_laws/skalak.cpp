// The membrane of a red blood cell after Skalak et al. (1973), per unit E_s (E_s = 2 G, paper eq. 28):
//   W = 1/8 [ I1² + 2 I1 − 2 I2 + C I2² ],   I1 = λ1² + λ2² − 2,  I2 = λ1² λ2² − 1
//   dW/dλ1 = λ1/2 [ I1 + 1 + λ2² (C I2 − 1) ],  and the same with 1 and 2 exchanged.
#include "solver/strain_laws/strain_law.hpp"

#include <sstream>

namespace capstan {
namespace {

/// The strain invariants of each face, #F.
struct Invariants {
  Eigen::ArrayXd I1, I2;

  explicit Invariants(const Principal& squared_stretches)
      : I1(squared_stretches.col(0) + squared_stretches.col(1) - 2),
        I2(squared_stretches.col(0) * squared_stretches.col(1) - 1) {}
};

Eigen::ArrayXd energy(const Principal& stretches, const LawConstants& constants) {
  const double C = constants[0];
  const Invariants strain(stretches.square());
  return (strain.I1.square() + 2 * strain.I1 - 2 * strain.I2 + C * strain.I2.square()) / 8;
}

Principal derivatives(const Principal& stretches, const LawConstants& constants) {
  const double C = constants[0];
  const Principal squares = stretches.square();
  const Invariants strain(squares);
  const Eigen::ArrayXd shear = strain.I1 + 1, dilation = C * strain.I2 - 1;
  Principal dW = stretches / 2;
  dW.col(0) *= shear + squares.col(1) * dilation;
  dW.col(1) *= shear + squares.col(0) * dilation;
  return dW;
}

/// Under uniaxial compression with C = 0 the tension has its largest magnitude at the stretch 1/sqrt(3) and
/// becomes weaker at smaller stretches. Only the area term, with C, resists further compression.
std::string advice_on_collapse(const LawConstants& constants) {
  constexpr double kMinStableC = 0.5;
  const double C = constants[0];
  if (C >= kMinStableC) return "";
  std::ostringstream advice;
  advice.precision(3);
  advice
      << "Skalak's law with C = " << C
      << " loses its resistance where the membrane is compressed to less than 0.58: raise C to 0.5 or more, "
         "or lower Ca.";
  return advice.str();
}

}  // namespace

StrainLaw skalak() {
  return {.name = "skalak",
          .modulus = "E_s = 2 G",
          .constants = {{"C", "Skalak's resistance to area dilation", 0, 1000}},
          .is_strain_hardening = true,
          .moduli =
              [](const LawConstants& constants) {
                return SmallStrainModuli{0.5, 0.5 + constants[0]};
              },
          .energy = energy,
          .derivatives = derivatives,
          .advice_on_collapse = advice_on_collapse};
}

}  // namespace capstan
