#pragma once
// Moving the membrane with the fluid: dX/dt = U(X, t) (paper eq. 37).
#include "solver/mesh/triangle_mesh.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// Second-order Adams-Bashforth (paper eq. 38), with one Euler step to start.
class AdamsBashforth2 {
 public:
  /// One step of size kdt with the velocities of its start.
  void advance(const Points& velocities, double kdt, Points& positions);

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  Points before_;  ///< velocities of the step before; empty at the start
};

}  // namespace capstan
