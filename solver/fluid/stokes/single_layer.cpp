#include "solver/fluid/stokes/single_layer.hpp"

#include <algorithm>
#include <numbers>

#include "solver/fluid/stokes/quadrature.hpp"

namespace capstan {
namespace {

struct PointForce {
  Eigen::Vector3f position, force;
};

/// Point forces near one target. Every quadrature rule replaces the force density by point forces, so that
/// one loop sums all rules.
class PointForces {
 public:
  void clear() { positions_.clear(), forces_.clear(); }
  void add(const PointForce& point) { positions_.push_back(point.position), forces_.push_back(point.force); }
  void add(const Vec3& position, const Vec3& force) { add({position.cast<float>(), force.cast<float>()}); }

  Vec3 velocity_at(const Vec3& x0) {
    positions_.finish(), forces_.finish();
    return sum_stokeslets(positions_, forces_, x0.cast<float>()).cast<double>();
  }

 private:
  PointArray positions_, forces_;
};

class SingleLayer {
 public:
  SingleLayer(const Surface& surface, const Neighbourhood& neighbourhood, const Points& forces)
      : surface_(surface), densities_(forces * surface.vertex_areas.cwiseInverse().asDiagonal()) {
    forces_.assign(forces);
    near_rules_.reserve(neighbourhood.near_faces().size());
    for (int face : neighbourhood.near_faces()) near_rules_.push_back(make_rule(face));
  }

  /// u at a target: the vertex rule over all faces, corrected on the faces near the target.
  /// \param near  scratch
  Vec3 at(int target, const Rings& rings, std::span<const CloseFace> close, PointForces& near) const {
    const Vec3 x0 = surface_.positions.col(target);
    near.clear();
    for (const Corner& corner : rings.one_ring) replace_by_rays(target, corner, near);
    for (int n : rings.two_ring) {
      const FaceRule& rule = near_rules_[n];
      if (rule.size.can_integrate_from(x0))
        for (const PointForce& point : rule.points) near.add(point);
      else
        replace_by_split_face(x0, rule.face, near);
    }
    for (const CloseFace& here : close) replace_by_split_face(x0, here.face, near);
    const Vec3 far = sum_stokeslets(surface_.points, forces_, x0.cast<float>()).cast<double>();
    return (far + near.velocity_at(x0)) / (8 * std::numbers::pi);
  }

 private:
  /// The contribution of a face to the vertex rule at one of its corners, with the opposite sign: it is
  /// subtracted where another rule is used on the face.
  PointForce taken_back(int face, int vertex) const {
    const Vec3 share = -surface_.face_areas[face] / 3 * densities_.col(vertex);
    return {surface_.positions.col(vertex).cast<float>(), share.cast<float>()};
  }

  /// The three-point rule on a face minus the contribution of the face to the vertex rule.
  struct FaceRule {
    int face;
    TriangleSize size;
    std::array<PointForce, 2 * kGaussPoints> points;
  };
  FaceRule make_rule(int face) const {
    const Eigen::Vector3i corners = surface_.mesh.faces.col(face);
    const Eigen::Matrix3d x = surface_.positions(Eigen::all, corners), f = densities_(Eigen::all, corners);
    FaceRule rule{face, TriangleSize(x), {}};
    for (int n = 0; n < kGaussPoints; ++n) {
      const TrianglePoint point = gauss_point(n);
      const Vec3 force = point.weight * surface_.face_areas[face] * (f * point.barycentric);
      rule.points[n] = {(x * point.barycentric).cast<float>(), force.cast<float>()};
      rule.points[kGaussPoints + n] = taken_back(face, corners[n]);
    }
    return rule;
  }

  // On a face (x0, a, b) of area A let x = x0 + rho e(s), where e(s) is the vector from x0 to the point s of
  // the edge ab. G(rho e) = G(e)/rho cancels the factor rho of dA = 2 A rho drho ds. With f linear along the
  // ray
  //   int G f dA = A int_0^1 G(e(s)) [f(x0) + f(x0 + e(s))] ds,
  // which the rule on (0, 1) turns into a sum of point forces on the edge ab.
  void replace_by_rays(int target, const Corner& corner, PointForces& near) const {
    const Vec3 a = surface_.positions.col(corner.next), b = surface_.positions.col(corner.last);
    const Vec3 f0 = densities_.col(target), fa = densities_.col(corner.next),
               fb = densities_.col(corner.last);
    for (const EdgePoint& point : kEdgeRule)
      near.add(a + point.s * (b - a),
               point.weight * surface_.face_areas[corner.face] * (f0 + fa + point.s * (fb - fa)));
    near.add(taken_back(corner.face, corner.next));
    near.add(taken_back(corner.face, corner.last));
  }

  void replace_by_split_face(const Vec3& x0, int face, PointForces& near) const {
    const Eigen::Vector3i corners = surface_.mesh.faces.col(face);
    const Eigen::Matrix3d x = surface_.positions(Eigen::all, corners), f = densities_(Eigen::all, corners);
    for (const TrianglePoint& point : refined_rule(x, x0))
      near.add(x * point.barycentric, point.weight * surface_.face_areas[face] * (f * point.barycentric));
    for (int vertex : corners) near.add(taken_back(face, vertex));
  }

  const Surface& surface_;
  Points densities_;                  ///< 3 x #V: f, force per area
  PointArray forces_;                 ///< forces of the vertices: the vertex rule
  std::vector<FaceRule> near_rules_;  ///< of neighbourhood.near_faces()
};

}  // namespace

Points single_layer(const Surface& surface, const Neighbourhood& neighbourhood,
                    const std::vector<CloseFace>& close, const Points& forces) {
  const SingleLayer layer(surface, neighbourhood, forces);
  const std::vector<int>& targets = neighbourhood.targets();
  Points velocities(3, targets.size());
#pragma omp parallel
  {
    PointForces near;
#pragma omp for schedule(dynamic, 16)
    for (int slot = 0; slot < int(targets.size()); ++slot)
      velocities.col(slot) =
          layer.at(targets[slot], neighbourhood.rings()[slot], close_to(close, slot), near);
  }
  return velocities;
}

}  // namespace capstan
