#include "solver/fluid/stokes/single_layer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numbers>

#include "solver/fluid/stokes/quadrature.hpp"

namespace capstan {
namespace {

using Vec3f = Eigen::Vector3f;

/// Point forces, one array a component: x, y, z of the positions, then of the forces. Every quadrature rule
/// replaces the force density on a face by point forces, so that one loop sums all rules.
///
/// Up to eight of them belong to one face. All eight places are written and copied, which is faster than a
/// loop over those in use.
constexpr int kPlaces = 8;
struct FaceForces {
  alignas(32) float components[6][kPlaces];
};

/// The point forces near one target.
class NearForces {
 public:
  void clear() { size_ = 0; }

  /// Adds the first `used` places of a face; the next face overwrites the others.
  /// \param write  writes component i of the face's point forces to an array of eight
  template <class Write>
  void add(int used, const Write& write) {
    if (size_ + kPlaces + PointArray::kLanes > capacity()) grow();
    for (int i = 0; i < 6; ++i) write(i, components_[i].data() + size_);
    size_ += used;
  }

  void add(const Vec3& position, const Vec3& force) {
    add(1, [&](int i, float* at) { *at = float(i < 3 ? position[i] : force[i - 3]); });
  }

  Vec3f sum_at(const Vec3f& x0) {
    const int padded = (size_ + PointArray::kLanes - 1) / PointArray::kLanes * PointArray::kLanes;
    for (auto& component : components_) std::fill(component.begin() + size_, component.begin() + padded, 0.f);
    return sum_stokeslets(padded, at(0), at(3), x0);
  }

 private:
  int capacity() const { return int(components_[0].size()); }
  void grow() {
    for (auto& component : components_) component.resize(size_t(2 * capacity() + 256));
  }
  Components at(int first) const {
    return {components_[first].data(), components_[first + 1].data(), components_[first + 2].data()};
  }

  int size_ = 0;
  std::array<std::vector<float>, 6> components_;
};

class SingleLayer {
 public:
  SingleLayer(const Surface& surface, const Neighbourhood& neighbourhood, const Points& forces)
      : surface_(surface),
        densities_(forces * surface.vertex_areas.cwiseInverse().asDiagonal()),
        positions_in_float_(surface.positions.cast<float>()),
        densities_in_float_(densities_.cast<float>()) {
    forces_.assign(forces);
    near_rules_.reserve(neighbourhood.near_faces().size());
    for (int face : neighbourhood.near_faces()) near_rules_.push_back(make_rule(face));
  }

  /// u at a target: the vertex rule over all faces, corrected on the faces near the target.
  /// \param near  scratch
  Vec3 at(int target, const Rings& rings, std::span<const CloseFace> close, NearForces& near) const {
    const Vec3f x0 = positions_in_float_.col(target);
    near.clear();
    for (const Corner& corner : rings.one_ring) replace_by_rays(target, corner, near);
    for (int n : rings.two_ring) {
      const FaceRule& rule = near_rules_[n];
      if ((rule.centre - x0).squaredNorm() >= rule.min_distance2)
        near.add(kRulePlaces, [&](int i, float* at) {
          std::memcpy(at, rule.forces.components[i], sizeof rule.forces.components[i]);
        });
      else
        replace_by_split_face(target, rule.face, near);
    }
    for (const CloseFace& here : close) replace_by_split_face(target, here.face, near);
    const Vec3f sum = sum_stokeslets(surface_.points, forces_, x0) + near.sum_at(x0);
    return sum.cast<double>() / (8 * std::numbers::pi);
  }

 private:
  float third_of_area(int face) const { return float(surface_.face_areas[face] / 3); }

  /// The three-point rule on a face minus the contribution of the face to the vertex rule, and where it
  /// holds.
  static constexpr int kRulePlaces = 2 * kGaussPoints;
  struct FaceRule {
    int face;
    Vec3f centre;
    float min_distance2;  ///< squared distance of a target from the centre
    FaceForces forces;
  };
  FaceRule make_rule(int face) const {
    const Eigen::Vector3i corners = surface_.mesh.faces.col(face);
    FaceRule rule{face, Vec3f::Zero(), 0, {}};
    const auto set = [&](int component, Vec3f of_corners, float taken_back) {
      float* const at = rule.forces.components[component];
      const float sixth =
          of_corners.sum() / 6;  // gauss_point(n): 1/6 of each corner and another 1/2 of corner n
      for (int n : {0, 1, 2})
        at[n] = sixth + of_corners[n] / 2, at[kGaussPoints + n] = taken_back * of_corners[n];
      at[2 * kGaussPoints] = at[2 * kGaussPoints + 1] = 0;
      return sixth;
    };
    const float third = third_of_area(face);
    Vec3f sides2 = Vec3f::Zero();
    for (int i : {0, 1, 2}) {
      const Vec3f x = positions_in_float_.row(i)(corners), f = third * densities_in_float_.row(i)(corners);
      rule.centre[i] = 2 * set(i, x, 1);
      set(3 + i, f, -1);
      const Vec3f side(x[1] - x[0], x[2] - x[1], x[0] - x[2]);
      sides2 += side.cwiseAbs2();
    }
    rule.min_distance2 = sides2.maxCoeff() / 4;
    return rule;
  }

  // On a face (x0, a, b) of area A let x = x0 + rho e(s), where e(s) is the vector from x0 to the point s of
  // the edge ab. G(rho e) = G(e)/rho cancels the factor rho of dA = 2 A rho drho ds. With f linear along the
  // ray
  //   int G f dA = A int_0^1 G(e(s)) [f(x0) + f(x0 + e(s))] ds,
  // which the rule on (0, 1) turns into a sum of point forces on the edge ab. The contributions of the face
  // to the vertex rule at a and b are taken back.
  static constexpr int kRayPlaces = int(kEdgeRule.size()) + 2;
  void replace_by_rays(int target, const Corner& corner, NearForces& near) const {
    static constexpr auto s = [] {
      std::array<float, kPlaces> positions{};
      for (size_t n = 0; n < kEdgeRule.size(); ++n) positions[n] = float(kEdgeRule[n].s);
      positions[kEdgeRule.size() + 1] = 1;
      return positions;
    }();
    static constexpr auto weights = [] {
      std::array<float, kPlaces> of_rule{};
      for (size_t n = 0; n < kEdgeRule.size(); ++n) of_rule[n] = float(kEdgeRule[n].weight);
      return of_rule;
    }();
    const float third = third_of_area(corner.face), area = 3 * third;
    near.add(kRayPlaces, [&](int component, float* at) {
      if (component < 3) {
        const float a = positions_in_float_(component, corner.next),
                    ab = positions_in_float_(component, corner.last) - a;
        for (int n = 0; n < kPlaces; ++n) at[n] = a + s[n] * ab;
        return;
      }
      const int i = component - 3;
      const float fa = densities_in_float_(i, corner.next), fb = densities_in_float_(i, corner.last);
      const float at_a = area * (densities_in_float_(i, target) + fa), rise = area * (fb - fa);
      for (int n = 0; n < kPlaces; ++n) at[n] = weights[n] * (at_a + s[n] * rise);
      at[kEdgeRule.size()] = -third * fa;
      at[kEdgeRule.size() + 1] = -third * fb;
    });
  }

  void replace_by_split_face(int target, int face, NearForces& near) const {
    const Eigen::Vector3i corners = surface_.mesh.faces.col(face);
    const Eigen::Matrix3d x = surface_.positions(Eigen::all, corners),
                          f = surface_.face_areas[face] * densities_(Eigen::all, corners);
    for (const TrianglePoint& point : refined_rule(x, surface_.positions.col(target)))
      near.add(x * point.barycentric, point.weight * (f * point.barycentric));
    for (int corner : {0, 1, 2}) near.add(x.col(corner), -f.col(corner) / 3);
  }

  const Surface& surface_;
  Points densities_;  ///< 3 x #V: f, force per area
  Eigen::Matrix3Xf positions_in_float_, densities_in_float_;
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
    NearForces near;
#pragma omp for schedule(dynamic, 16)
    for (int slot = 0; slot < int(targets.size()); ++slot)
      velocities.col(slot) =
          layer.at(targets[slot], neighbourhood.rings()[slot], close_to(close, slot), near);
  }
  return velocities;
}

}  // namespace capstan
