#pragma once
// A strain law: the elastic energy of a membrane in its plane as a function of the two principal stretches.
// Each law is one file of this folder and one row of strain_laws.def.
#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// #F x 2, one row a face: the principal stretches lambda1, lambda2 (deformed over undeformed length, > 0),
/// or one quantity for each of them.
using Principal = Eigen::ArrayX2d;

/// Values of a law's constants, in the order of StrainLaw::constants.
using LawConstants = std::vector<double>;

/// A dimensionless material constant that a case file must give.
struct LawConstant {
  std::string_view key;          ///< in case files, e.g. "C"
  std::string_view description;  ///< a noun, e.g. "Skalak's resistance to area dilation"
  double min, max;               ///< both are allowed values
};

/// Moduli for small strains, per unit E_s:  W = 1/2 [ (K + G)(e1² + e2²) + 2 (K − G) e1 e2 ],  λi = 1 + ei.
struct SmallStrainModuli {
  double shear;  ///< G
  double area;   ///< K
};

/// A hyperelastic, isotropic law per unit of the surface modulus E_s. Functions take all faces at once.
struct StrainLaw {
  std::string_view name;               ///< in case files, e.g. "skalak"
  std::string_view modulus;            ///< definition of E_s by the shear modulus G, e.g. "E_s = 2 G"
  std::vector<LawConstant> constants;  ///< those that a case must give; none for many laws

  /// Whether the membrane becomes stiffer as it is stretched, so that its deformation stays limited in any
  /// shear flow.
  bool is_strain_hardening = false;

  SmallStrainModuli (*moduli)(const LawConstants& constants);

  /// #F: W, energy per undeformed area and E_s.
  Eigen::ArrayXd (*energy)(const Principal& stretches, const LawConstants& constants);

  /// #F x 2: dW/dλ1, dW/dλ2. The principal tensions are τ1 = dW/dλ1 / λ2 and τ2 = dW/dλ2 / λ1, positive where
  /// the membrane pulls.
  Principal (*derivatives)(const Principal& stretches, const LawConstants& constants);

  /// Advice to the user when a membrane with these constants has collapsed; nullptr or "" for none.
  std::string (*advice_on_collapse)(const LawConstants& constants) = nullptr;
};

}  // namespace capstan
