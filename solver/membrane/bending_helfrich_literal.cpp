#include "solver/membrane/bending_helfrich_literal.hpp"

#include "solver/mesh/curvature.hpp"
#include "solver/mesh/quadric_fit.hpp"

namespace capstan {

void HelfrichLiteralBending::add_forces(const Points& positions, Points& forces) const {
  const QuadricFit surface = fit_quadrics(mesh_, positions);
  const Scalars kappa = -surface.mean;
  const Eigen::ArrayXd laplacian = laplace_beltrami(mesh_.faces, positions, kappa);
  const Eigen::ArrayXd voronoi = mixed_areas(positions, mesh_.faces);
  const auto k = kappa.array(), K = surface.gaussian.array(), c0 = spontaneous_curvature_.array();
  const Eigen::ArrayXd density =
      modulus_ * ((2 * k + c0) * (2 * k.square() - 2 * K - c0 * k) + 2 * laplacian);
  forces -= surface.normals * (density * voronoi).matrix().asDiagonal();
}

}  // namespace capstan
