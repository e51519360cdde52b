#pragma once
#include "solver/membrane/strain_law.hpp"

namespace capstan {

/// The red blood cell membrane of Skalak et al., per unit E_s (E_s = 2 G, paper eq. 28):
///   W = 1/8 [ I1² + 2 I1 − 2 I2 + C I2² ],   I1 = λ1² + λ2² − 2,  I2 = λ1² λ2² − 1
///   dW/dλ1 = λ1/2 [ I1 + 1 + λ2² (C I2 − 1) ],  and the same with 1 and 2 exchanged.
class Skalak final : public StrainLaw {
 public:
  /// \param C resistance to area dilation; the area modulus is (1 + 2 C)/2 per unit E_s.
  explicit Skalak(double C) : C_(C) {}

  Eigen::ArrayXd energy(const Principal& stretches) const override;
  Principal derivatives(const Principal& stretches) const override;

 private:
  double C_;
};

}  // namespace capstan
