#pragma once
// The membrane at one instant of a run.
#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

struct MembraneState {
  double kt = 0;
  Points positions, velocities;  ///< 3 x #V
  Points forces;                 ///< 3 x #V, by the membrane on the fluid
};

/// The membrane between two steps, a.kt <= kt <= b.kt. Positions: the cubic in time that has the positions
/// and velocities of both states (Hermite interpolation). Velocities: the derivative of this cubic. Forces:
/// linear in time. The error of the positions, at most step^4 / 384 times their fourth derivative, is smaller
/// than that of the steps.
inline MembraneState between(const MembraneState& a, const MembraneState& b, double kt) {
  const double step = b.kt - a.kt, s = (kt - a.kt) / step;
  const double blend = s * s * (3 - 2 * s), slope = 6 * s * (1 - s) / step;
  MembraneState state{.kt = kt, .positions = {}, .velocities = {}, .forces = {}};
  state.positions = (1 - blend) * a.positions + blend * b.positions +
                    step * s * (1 - s) * ((1 - s) * a.velocities - s * b.velocities);
  state.velocities = slope * (b.positions - a.positions) + (1 - s) * (1 - 3 * s) * a.velocities +
                     s * (3 * s - 2) * b.velocities;
  state.forces = (1 - s) * a.forces + s * b.forces;
  return state;
}

}  // namespace capstan
