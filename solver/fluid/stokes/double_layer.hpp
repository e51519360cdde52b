#pragma once
// What a viscosity contrast does to the flow (Pozrikidis 1992, section 5.3), with the velocity at x0
// subtracted:
//   K u(x0) = 1/(8 pi) int [u(x) - u(x0)]_i T_ijk(x - x0) n_k dA
// The integrand is bounded, so the vertex rule serves without any term for x0 itself, and K of a rigid motion
// is zero exactly. On the sphere a strain has K u = 2/5 u.
#include "solver/fluid/stokes/neighbourhood.hpp"

namespace capstan {

class DoubleLayer {
 public:
  /// \param close of neighbourhood.close_faces(surface): there the faces are split
  DoubleLayer(const Surface& surface, const Neighbourhood& neighbourhood,
              const std::vector<CloseFace>& close);

  /// K u.  \param velocities 3 x #V   \return 3 x #targets
  Points apply(const Points& velocities) const;

 private:
  /// What a close face adds to the vertex rule, for the velocities of its corners against that of the target.
  struct Correction {
    int slot;
    Eigen::Vector3i corners;
    std::array<Eigen::Matrix3d, 3> of_corner;
  };
  static Correction make_correction(const Surface& surface, int target, const CloseFace& here);

  const Surface& surface_;
  const std::vector<int>& targets_;
  PointArray area_vectors_;
  std::vector<Correction> corrections_;
};

}  // namespace capstan
