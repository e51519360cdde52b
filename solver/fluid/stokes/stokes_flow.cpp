#include "solver/fluid/stokes/stokes_flow.hpp"

#include <cmath>

#include "solver/fluid/stokes/double_layer.hpp"
#include "solver/fluid/stokes/gmres.hpp"
#include "solver/fluid/stokes/single_layer.hpp"

namespace capstan {
namespace {

constexpr int kMaxProducts = 150;
// The residual is a small part of the tolerance: errors of extrapolated solutions are alike and add up.
constexpr double kResidualShare = 0.3;
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

/// The inverse of 1 - (1 - V) K for short waves, on which the surface is flat and K u(x0) is -u(x0)/2, from
/// the subtracted density.
double inverse_for_short_waves(double V) { return 2 / (1 + V); }

}  // namespace

StokesFlow::StokesFlow(const TriangleMesh& mesh, Orbits orbits, const StokesOptions& options)
    : mesh_(mesh),
      orbits_(std::move(orbits)),
      neighbourhood_(mesh_, orbits_.representatives()),
      options_(options),
      guess_(inverse_for_short_waves(options.V)) {}

FlowReport StokesFlow::solve(double, const Points& positions, const Points& forces, Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  const Surface surface(mesh_, positions);
  const std::vector<CloseFace> close = neighbourhood_.close_faces(surface);
  const Points driven = orbits_.restrict(shear_flow(positions)) +
                        single_layer(surface, neighbourhood_, close, without_pressure(forces, surface));
  Points solution;
  const FlowReport report = solve_integral_equation(surface, close, driven, solution);

  const Points normals = surface.vertex_area_vectors.colwise().normalized();
  const double drift = flux(positions, surface) / 3 - options_.volume;  // div x = 3
  const double outflow = flux(orbits_.extend(solution), surface) + kVolumeRate * drift;
  velocities = orbits_.extend(solution - outflow / flux(normals, surface) * orbits_.restrict(normals));
  if (!velocities.allFinite()) return lost_flow("the flow is not finite");
  return report;
}

/// Solves u - (1 - V) K u = driven at the representatives.
/// \param solution  3 x #representatives, result
FlowReport StokesFlow::solve_integral_equation(const Surface& surface, const std::vector<CloseFace>& close,
                                               const Points& driven, Points& solution) {
  if (options_.V == 1) {
    solution = driven;
    return {.iterations = 1};
  }
  const DoubleLayer double_layer(surface, neighbourhood_, close);
  const auto apply = [&](const Eigen::VectorXd& u) -> Eigen::VectorXd {
    const Points all = orbits_.extend(u.reshaped(3, u.size() / 3));
    return u - (1 - options_.V) * double_layer.apply(all).reshaped();
  };
  const Eigen::VectorXd right_side = driven.reshaped();
  Eigen::VectorXd u = guess_.solution_of(right_side);
  const LinearSolution solved =
      solve_gmres(apply, right_side, kResidualShare * options_.tolerance, kMaxProducts, u);
  u +=
      inverse_for_short_waves(options_.V) * solved.residual;  // costs no product and lowers the error further
  guess_.remember(right_side, u);
  solution = u.reshaped(3, u.size() / 3);
  FlowReport report{.iterations = solved.products, .error = solved.relative_error};
  if (!(solved.relative_error <= options_.tolerance)) {
    report.converged = false;
    report.reason =
        "the boundary integral equation did not converge: raise tolerance, take V nearer to 1, or the fluid "
        "quasisteady";
  }
  return report;
}

void StokesFlow::save(StateArchive& archive) const { guess_.save(archive); }

void StokesFlow::load(const StateArchive& archive) { guess_.load(archive); }

}  // namespace capstan
