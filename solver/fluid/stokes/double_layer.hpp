#pragma once
// The double layer potential, by which a viscosity ratio affects the flow (Pozrikidis 1992, section 5.3),
// with the velocity at x0 subtracted from the density:
//   K u(x0)_j = 1/(8 pi) int [u(x) - u(x0)]_i T_ijk(x - x0) n_k dA.
// The integrand is bounded, so the vertex rule can leave out x0 itself, and K u = 0 exactly for a rigid
// motion. On the unit sphere K u = 2/5 u for a pure strain u.
#include "solver/fluid/stokes/neighbourhood.hpp"

namespace capstan {

class DoubleLayer {
 public:
  /// \param close  result of neighbourhood.close_faces(surface): these faces are split for a more accurate
  /// rule
  DoubleLayer(const Surface& surface, const Neighbourhood& neighbourhood,
              const std::vector<CloseFace>& close);

  /// K u.  \param velocities 3 x #V   \return 3 x #targets
  Points apply(const Points& velocities) const;

 private:
  /// The integral over a close face minus the contribution of this face to the vertex rule: a linear function
  /// of the velocities of its corners relative to that of the target.
  struct Correction {
    int slot;  ///< of the target
    Eigen::Vector3i corners;
    std::array<Eigen::Matrix3d, 3> of_corner;  ///< factor of each corner's relative velocity
  };
  static Correction make_correction(const Surface& surface, int target, const CloseFace& here);

  const Surface& surface_;
  const std::vector<int>& targets_;
  PointArray area_vectors_;
  std::vector<Correction> corrections_;
};

}  // namespace capstan
