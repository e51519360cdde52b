#include "solver/membrane/in_plane.hpp"

#include <cmath>
#include <utility>

namespace capstan {
namespace {

using DeformationGradient = Eigen::Matrix<double, 3, 2>;

/// F = sum_a x_a (grad N_a)^T. Charrier's rotation into a common plane drops out of C = F^T F.
template <class Element>
DeformationGradient deformation_gradient(const Element& element, const Points& positions) {
  DeformationGradient F = positions.col(element.vertices[0]) * element.gradients.col(0).transpose();
  F += positions.col(element.vertices[1]) * element.gradients.col(1).transpose();
  F += positions.col(element.vertices[2]) * element.gradients.col(2).transpose();
  return F;
}

/// C = F^T F, symmetric, as  mean * 1 + difference * [cosine, sine; sine, -cosine];  its eigenvalues are the
/// squared principal stretches mean +- difference. Any direction serves where they are equal.
struct CauchyGreen {
  double mean, difference, cosine = 1, sine = 0;

  explicit CauchyGreen(const DeformationGradient& F) {
    const double c11 = F.col(0).squaredNorm(), c22 = F.col(1).squaredNorm(), c12 = F.col(0).dot(F.col(1));
    mean = (c11 + c22) / 2;
    difference = std::sqrt((c11 - c22) * (c11 - c22) / 4 + c12 * c12);
    if (difference > 0) {
      cosine = (c11 - c22) / (2 * difference);
      sine = c12 / difference;
    }
  }

  /// The symmetric matrix with the same eigenvectors and the eigenvalues s1, s2.
  Eigen::Matrix2d with_eigenvalues(double s1, double s2) const {
    const double half_sum = (s1 + s2) / 2, half_difference = (s1 - s2) / 2;
    Eigen::Matrix2d S;
    S << half_sum + half_difference * cosine, half_difference * sine,  //
        half_difference * sine, half_sum - half_difference * cosine;
    return S;
  }
};

}  // namespace

InPlaneElasticity::InPlaneElasticity(const Faces& faces, const Points& reference,
                                     std::unique_ptr<StrainLaw> law, double modulus)
    : law_(std::move(law)), modulus_(modulus) {
  elements_.reserve(static_cast<size_t>(faces.cols()));
  for (const auto& face : faces.colwise()) elements_.push_back(make_element(face, reference));
}

// In the undeformed plane the corners are (0, 0), (length, 0), (foot, height); grad N_a is the inner normal
// of the side opposite to corner a, over its height.
InPlaneElasticity::Element InPlaneElasticity::make_element(const Eigen::Vector3i& face,
                                                           const Points& reference) {
  const Vec3 side1 = reference.col(face[1]) - reference.col(face[0]);
  const Vec3 side2 = reference.col(face[2]) - reference.col(face[0]);
  const double length = side1.norm();
  const double foot = side1.dot(side2) / length;
  const double height = side1.cross(side2).norm() / length;
  Element element{{face[0], face[1], face[2]}, {}, length * height / 2};
  element.gradients << -height, height, 0,  //
      foot - length, -foot, length;
  element.gradients /= length * height;
  return element;
}

Principal InPlaneElasticity::stretches(const Points& positions) const {
  Principal squares(elements_.size(), 2);
  for (size_t face = 0; face < elements_.size(); ++face) {
    const CauchyGreen C(deformation_gradient(elements_[face], positions));
    squares(face, 0) = C.mean + C.difference;
    squares(face, 1) = C.mean - C.difference;
  }
  return squares.sqrt();
}

// dE/dx_a = E_s A0 F S grad N_a with the second Piola-Kirchhoff tension S, whose principal values are
// dW/dlambda_i / lambda_i: eq. 29 without the detour over displacements in a common plane.
void InPlaneElasticity::add_forces(const Points& positions, Points& forces) const {
  const Principal lambda = stretches(positions);
  const Principal tension = law_->derivatives(lambda) / lambda;
  for (size_t face = 0; face < elements_.size(); ++face) {
    const Element& element = elements_[face];
    const DeformationGradient F = deformation_gradient(element, positions);
    const Eigen::Matrix2d S = CauchyGreen(F).with_eigenvalues(tension(face, 0), tension(face, 1));
    const DeformationGradient stress = modulus_ * element.area * (F * S);
    for (int corner : {0, 1, 2})
      forces.col(element.vertices[corner]) -= stress * element.gradients.col(corner);
  }
}

double InPlaneElasticity::energy(const Points& positions) const {
  const Eigen::ArrayXd density = law_->energy(stretches(positions));
  double sum = 0;
  for (size_t face = 0; face < elements_.size(); ++face) sum += elements_[face].area * density[face];
  return modulus_ * sum;
}

}  // namespace capstan
