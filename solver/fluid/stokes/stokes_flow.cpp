#include "solver/fluid/stokes/stokes_flow.hpp"

#include <cmath>

#include "solver/fluid/stokes/double_layer.hpp"
#include "solver/fluid/stokes/gmres.hpp"
#include "solver/fluid/stokes/single_layer.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/state/points_archive.hpp"

namespace capstan {
namespace {

constexpr int kMaxProducts = 150;
constexpr double kVolumeRate = 10;  // rate in units of k at which a volume error decays: fast compared with
                                    // the flow, slow compared with the elastic relaxation

Points shear_flow(const Points& positions) {
  Points velocities = Points::Zero(3, positions.cols());
  velocities.row(0) = positions.row(1);
  return velocities;
}

/// sum_i v_i . N_i, the flux of a vector field through the surface.
double flux(const Points& vectors, const Surface& surface) {
  return vectors.cwiseProduct(surface.vertex_area_vectors).sum();
}

/// Forces minus their component along N (all vertices taken as one vector), which is the force of a uniform
/// pressure. A uniform pressure drives no flow, but the discretised single layer of it is not exactly zero.
Points without_pressure(const Points& forces, const Surface& surface) {
  const Points& area_vectors = surface.vertex_area_vectors;
  return forces - flux(forces, surface) / area_vectors.squaredNorm() * area_vectors;
}

}  // namespace

StokesFlow::StokesFlow(const TriangleMesh& mesh, Orbits orbits, const StokesOptions& options)
    : mesh_(mesh),
      orbits_(std::move(orbits)),
      neighbourhood_(mesh_, orbits_.representatives()),
      options_(options) {}

FlowReport StokesFlow::solve(double, const Points& positions, const Points& forces, Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  const Surface surface(mesh_, positions);
  const std::vector<CloseFace> close = neighbourhood_.close_faces(surface);
  const Points driven = orbits_.restrict(shear_flow(positions)) +
                        single_layer(surface, neighbourhood_, close, without_pressure(forces, surface));
  const FlowReport report = solve_integral_equation(surface, close, driven);

  const Points normals = surface.vertex_area_vectors.colwise().normalized();
  const double drift = volume(positions, mesh_.faces) - options_.volume;
  const double outflow = flux(orbits_.extend(last_), surface) + kVolumeRate * drift;
  velocities = orbits_.extend(last_ - outflow / flux(normals, surface) * orbits_.restrict(normals));
  if (!velocities.allFinite()) return lost_flow("the flow is not finite");
  return report;
}

/// Solves u - (1 - V) K u = driven at the representatives. The solution is last_.
FlowReport StokesFlow::solve_integral_equation(const Surface& surface, const std::vector<CloseFace>& close,
                                               const Points& driven) {
  if (options_.V == 1) {
    last_ = driven;
    return {.iterations = 1};
  }
  if (last_.size() == 0) last_ = driven;
  const DoubleLayer double_layer(surface, neighbourhood_, close);
  const auto apply = [&](const Eigen::VectorXd& u) -> Eigen::VectorXd {
    const Points all = orbits_.extend(u.reshaped(3, u.size() / 3));
    return u - (1 - options_.V) * double_layer.apply(all).reshaped();
  };
  Eigen::VectorXd u = last_.reshaped();
  const LinearSolution solution = solve_gmres(apply, driven.reshaped(), options_.tolerance, kMaxProducts, u);
  last_ = u.reshaped(3, u.size() / 3);
  FlowReport report{.iterations = solution.products, .error = solution.relative_error};
  if (!(solution.relative_error <= options_.tolerance)) {
    report.converged = false;
    report.reason =
        "the boundary integral equation did not converge: raise tolerance, take V nearer to 1, or the fluid "
        "quasisteady";
  }
  return report;
}

void StokesFlow::save(StateArchive& archive) const { put_points(archive, "fluid/last", last_); }

void StokesFlow::load(const StateArchive& archive) { last_ = get_points(archive, "fluid/last"); }

}  // namespace capstan
