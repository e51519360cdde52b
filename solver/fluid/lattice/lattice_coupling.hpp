#pragma once
// Between a capsule and the finest lattice: forces and viscosities onto the cells, velocities back to the
// vertices.
#include <optional>

#include "solver/case/units.hpp"
#include "solver/coupling/immersed_boundary.hpp"
#include "solver/coupling/viscosity_field.hpp"
#include "solver/fluid/lattice/level.hpp"

namespace capstan {

class LatticeCoupling {
 public:
  LatticeCoupling(const Case& c, const TriangleMesh& mesh, const LatticeUnits& units);

  /// Puts the membrane onto the levels, finest first. False when a position is not finite or too close to the
  /// boundary of the domain.
  bool put_membrane(const Points& positions, const Points& forces, std::span<Level> levels);

  /// Velocities of the vertices, units of a k.
  void vertex_velocities(const Level& finest, Points& velocities);

  /// Why put_membrane was false.
  static constexpr const char* kOutside = "the capsule left the domain or its positions are not finite";

 private:
  void put_viscosity(const Points& positions, std::span<Level> levels);

  LatticeUnits units_;
  int cells_;        ///< along an edge of the domain
  double contrast_;  ///< V
  ImmersedBoundary boundary_;
  std::optional<ViscosityField> viscosity_;  ///< none for V = 1
  VectorBox force_, velocity_;
  ScalarBox nu_;
};

}  // namespace capstan
