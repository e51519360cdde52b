#include "solver/membrane/bending.hpp"

#include "solver/membrane/bending_helfrich_literal.hpp"
#include "solver/membrane/bending_juelicher.hpp"
#include "solver/mesh/folded_surface.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/quadric_fit.hpp"

namespace capstan {
namespace {

/// #V: 2H of the reference shape, discretised as in the bending model of the case.
Scalars initial_curvature(const Case& c, const TriangleMesh& mesh, const Points& reference) {
  if (c.bending == BendingModel::variational) return FoldedSurface(mesh, reference).total_curvatures;
  return 2 * fit_quadrics(mesh, reference).mean;
}

}  // namespace

Scalars spontaneous_curvature(const Case& c, const TriangleMesh& mesh, const Points& reference) {
  if (const double* number = std::get_if<double>(&c.c0)) return Scalars::Constant(reference.cols(), *number);
  const Scalars initial = initial_curvature(c, mesh, reference);
  if (std::holds_alternative<InitialCurvature>(c.c0)) return initial;
  const Scalars areas = vertex_areas(reference, mesh.faces);
  return Scalars::Constant(initial.size(), initial.dot(areas) / areas.sum());
}

std::unique_ptr<Bending> make_bending(const Case& c, const TriangleMesh& mesh,
                                      const Scalars& spontaneous_curvature, double modulus) {
  if (!c.has_bending()) return nullptr;
  if (c.bending == BendingModel::variational)
    return std::make_unique<JuelicherBending>(mesh, spontaneous_curvature, modulus);
  return std::make_unique<HelfrichLiteralBending>(mesh, spontaneous_curvature, modulus);
}

}  // namespace capstan
