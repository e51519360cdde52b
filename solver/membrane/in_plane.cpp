#include "solver/membrane/in_plane.hpp"

#include <cmath>
#include <utility>

namespace capstan {
namespace {

/// F, 3 x 2: the images of the two orthonormal axes of the undeformed plane. It maps the side (length, 0) to
/// x1 - x0 and (foot, height) to x2 - x0. Charrier's rotation of both triangles into a common plane is not
/// needed, because it cancels in C = F^T F.
struct DeformationGradient {
  Vec3 axis1, axis2;

  template <class Element>
  DeformationGradient(const Element& element, const Points& x) {
    const auto [i, j, k] = element.vertices;
    const Vec3 base = x.col(j) - x.col(i);
    axis1 = element.inverse_length * base;
    axis2 = element.inverse_height * (x.col(k) - x.col(i) - element.slant * base);
  }
};

struct SymmetricMatrix {
  double s11, s12, s22;
};

/// C = F^T F, symmetric, as  mean * 1 + [d, e; e, -d].  Its eigenvalues, the squared principal stretches, are
/// mean +- radius,  radius^2 = d^2 + e^2.
struct CauchyGreen {
  double mean, d, e, radius;

  explicit CauchyGreen(const DeformationGradient& F) {
    const double c11 = F.axis1.squaredNorm(), c22 = F.axis2.squaredNorm();
    mean = (c11 + c22) / 2;
    d = (c11 - c22) / 2;
    e = F.axis1.dot(F.axis2);
    radius = std::sqrt(d * d + e * e);
  }

  /// The symmetric matrix with the eigenvectors of C and the eigenvalues s1, s2. If C has equal eigenvalues,
  /// s1 and s2 must be equal, too.
  SymmetricMatrix with_eigenvalues(double s1, double s2) const {
    const double middle = (s1 + s2) / 2;
    const double scale = radius > 0 ? (s1 - s2) / (2 * radius) : 0;
    return {middle + scale * d, scale * e, middle - scale * d};
  }
};

}  // namespace

InPlaneElasticity::InPlaneElasticity(const Faces& faces, const Points& reference, const StrainLaw& law,
                                     LawConstants constants, double modulus)
    : law_(law), constants_(std::move(constants)), modulus_(modulus) {
  elements_.reserve(static_cast<size_t>(faces.cols()));
  for (const auto& face : faces.colwise()) elements_.push_back(make_element(face, reference));
}

InPlaneElasticity::Element InPlaneElasticity::make_element(const Eigen::Vector3i& face,
                                                           const Points& reference) {
  const Vec3 base = reference.col(face[1]) - reference.col(face[0]);
  const Vec3 side = reference.col(face[2]) - reference.col(face[0]);
  const double length = base.norm();
  const double height = base.cross(side).norm() / length;
  return {{face[0], face[1], face[2]},
          1 / length,
          base.dot(side) / (length * length),
          1 / height,
          length * height / 2};
}

Principal InPlaneElasticity::stretches(const Points& positions) const {
  Principal squares(elements_.size(), 2);
  for (size_t face = 0; face < elements_.size(); ++face) {
    const CauchyGreen C(DeformationGradient(elements_[face], positions));
    squares(face, 0) = C.mean + C.radius;
    squares(face, 1) = C.mean - C.radius;
  }
  return squares.sqrt();
}

Scalars InPlaneElasticity::vertex_stretches(const Points& positions) const {
  const Principal lambda = stretches(positions);
  Scalars sums = Scalars::Zero(positions.cols()), areas = sums;
  for (size_t face = 0; face < elements_.size(); ++face)
    for (const int vertex : elements_[face].vertices) {
      sums[vertex] += elements_[face].area * lambda(face, 0);
      areas[vertex] += elements_[face].area;
    }
  return sums.cwiseQuotient(areas);
}

// dE = E_s A0 (F S) : dF, where S is the second Piola-Kirchhoff tension with the principal values
// dW/dlambda_i / lambda_i. This is eq. 29, written without the displacements in a common plane that the paper
// uses.
void InPlaneElasticity::add_forces(const Points& positions, Points& forces) const {
  const Principal lambda = stretches(positions);
  const Principal tension = law_.derivatives(lambda, constants_) / lambda;
  for (size_t face = 0; face < elements_.size(); ++face) {
    const Element& element = elements_[face];
    const DeformationGradient F(element, positions);
    const SymmetricMatrix S = CauchyGreen(F).with_eigenvalues(tension(face, 0), tension(face, 1));
    const double weight = modulus_ * element.area;
    const Vec3 at_tip = weight * element.inverse_height * (S.s12 * F.axis1 + S.s22 * F.axis2);
    const Vec3 at_base =
        weight * element.inverse_length * (S.s11 * F.axis1 + S.s12 * F.axis2) - element.slant * at_tip;
    const auto [i, j, k] = element.vertices;
    forces.col(i) += at_base + at_tip;
    forces.col(j) -= at_base;
    forces.col(k) -= at_tip;
  }
}

double InPlaneElasticity::energy(const Points& positions) const {
  const Eigen::ArrayXd density = law_.energy(stretches(positions), constants_);
  double sum = 0;
  for (size_t face = 0; face < elements_.size(); ++face) sum += elements_[face].area * density[face];
  return modulus_ * sum;
}

}  // namespace capstan
