#pragma once
// Forces of a membrane that resists stretching and shearing in its plane: the linear triangles of Charrier et
// al., paper section IV A and eq. 29.
#include <array>
#include <memory>
#include <vector>

#include "solver/membrane/strain_law.hpp"
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

/// Total energy  E = E_s sum over faces A0 W(lambda1, lambda2),  A0 the undeformed area of the face.
class InPlaneElasticity {
 public:
  /// \param reference 3 x #V, the shape without tension   \param modulus E_s
  InPlaneElasticity(const Faces& faces, const Points& reference, std::unique_ptr<StrainLaw> law,
                    double modulus);

  /// Adds -dE/dx, the force of the membrane on the fluid at each vertex.
  void add_forces(const Points& positions, Points& forces) const;

  double energy(const Points& positions) const;

  /// #F x 2: principal stretches, the larger first.
  Principal stretches(const Points& positions) const;

 private:
  /// A flat triangle; undeformed its corners are (0, 0), (length, 0), (foot, height) in a frame of its plane.
  struct Element {
    std::array<int, 3> vertices;
    double inverse_length, slant, inverse_height;  ///< slant = foot / length
    double area;                                   ///< undeformed
  };
  static Element make_element(const Eigen::Vector3i& face, const Points& reference);

  std::vector<Element> elements_;
  std::unique_ptr<StrainLaw> law_;
  double modulus_;
};

}  // namespace capstan
