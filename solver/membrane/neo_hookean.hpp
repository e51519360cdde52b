#pragma once
#include "solver/membrane/strain_law.hpp"

namespace capstan {

/// A thin sheet of incompressible rubber, per unit E_s (E_s = 3 G, paper eq. 27):
///   W = 1/6 [ λ1² + λ2² + 1/(λ1² λ2²) − 3 ]
///   dW/dλ1 = 1/3 [ λ1 − 1/(λ1³ λ2²) ],  and the same with 1 and 2 exchanged.
class NeoHookean final : public StrainLaw {
 public:
  Eigen::ArrayXd energy(const Principal& stretches) const override;
  Principal derivatives(const Principal& stretches) const override;
};

}  // namespace capstan
