#include "solver/membrane/bending.hpp"

#include "solver/membrane/bending_helfrich_literal.hpp"
#include "solver/membrane/bending_juelicher.hpp"
#include "solver/mesh/folded_surface.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/quadric_fit.hpp"

namespace capstan {
namespace {

/// The spontaneous curvature at every vertex. \param initial #V: 2H of the reference
Scalars spontaneous_curvature(const Case& c, const TriangleMesh& mesh, const Points& reference, const Scalars& initial) {
  if (const double* number = std::get_if<double>(&c.c0)) return Scalars::Constant(initial.size(), *number);
  if (std::holds_alternative<InitialCurvature>(c.c0)) return initial;
  const Scalars areas = vertex_areas(reference, mesh.faces);
  return Scalars::Constant(initial.size(), initial.dot(areas) / areas.sum());
}

}  // namespace

std::unique_ptr<Bending> make_bending(const Case& c, const TriangleMesh& mesh, const Points& reference,
                                      double modulus) {
  if (!c.has_bending()) return nullptr;
  if (c.bending == BendingModel::variational) {
    const Scalars c0 = spontaneous_curvature(c, mesh, reference, FoldedSurface(mesh, reference).total_curvatures);
    return std::make_unique<JuelicherBending>(mesh, c0, modulus);
  }
  const Scalars c0 = spontaneous_curvature(c, mesh, reference, 2 * fit_quadrics(mesh, reference).mean);
  return std::make_unique<HelfrichLiteralBending>(mesh, c0, modulus);
}

}  // namespace capstan
