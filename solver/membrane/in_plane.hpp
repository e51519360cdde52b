#pragma once
// Elastic forces in the plane of the membrane, by the linear triangular finite elements of Charrier et al.,
// paper section IV A and eq. 29.
#include <array>
#include <vector>

#include "solver/mesh/triangle_mesh.hpp"
#include "solver/strain_laws/strain_law.hpp"

namespace capstan {

/// Total energy  E = E_s sum over faces A0 W(lambda1, lambda2),  A0 the undeformed area of the face.
class InPlaneElasticity {
 public:
  /// \param reference 3 x #V, the shape without tension   \param constants of the law   \param modulus E_s
  InPlaneElasticity(const Faces& faces, const Points& reference, const StrainLaw& law, LawConstants constants,
                    double modulus);

  /// Adds -dE/dx, the force of the membrane on the fluid at each vertex.
  void add_forces(const Points& positions, Points& forces) const;

  double energy(const Points& positions) const;

  /// #F x 2: principal stretches of each face, the larger first.
  Principal stretches(const Points& positions) const;

  /// #V: the larger principal stretch at each vertex, the average over its faces by undeformed area.
  Scalars vertex_stretches(const Points& positions) const;

 private:
  /// A triangle. In a frame of the undeformed plane its corners are (0, 0), (length, 0) and (foot, height).
  struct Element {
    std::array<int, 3> vertices;
    double inverse_length, slant, inverse_height;  ///< slant = foot / length
    double area;                                   ///< undeformed
  };
  static Element make_element(const Eigen::Vector3i& face, const Points& reference);

  std::vector<Element> elements_;
  const StrainLaw& law_;  ///< a row of the table
  LawConstants constants_;
  double modulus_;
};

}  // namespace capstan
