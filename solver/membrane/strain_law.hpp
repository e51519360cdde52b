#pragma once
// What a membrane material is: its strain energy as a function of the two principal stretches.
#include <Eigen/Core>
#include <memory>

#include "solver/case/case.hpp"

namespace capstan {

/// #F x 2: lambda1, lambda2 of every face, or what belongs to them. A stretch is deformed over undeformed
/// length.
using Principal = Eigen::ArrayX2d;

/// A hyperelastic, isotropic law per unit of the surface modulus E_s; which modulus that is, each law says.
/// It works on all faces at once, so that nothing is dispatched face by face. Stretches must be positive.
class StrainLaw {
 public:
  virtual ~StrainLaw() = default;

  /// #F: W, energy per unit of undeformed area.
  virtual Eigen::ArrayXd energy(const Principal& stretches) const = 0;

  /// #F x 2: dW/dlambda1, dW/dlambda2. The principal tensions are tau1 = dW/dlambda1 / lambda2 and
  /// tau2 = dW/dlambda2 / lambda1, positive when the membrane pulls.
  virtual Principal derivatives(const Principal& stretches) const = 0;
};

std::unique_ptr<StrainLaw> make_strain_law(const Case& c);

}  // namespace capstan
