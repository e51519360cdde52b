#pragma once
// The state of a run at the time of one record, from which the observables are computed.
#include "solver/case/case.hpp"
#include "solver/mesh/triangle_mesh.hpp"
#include "solver/observe/motion_sample.hpp"

namespace capstan {

/// Lengths are in units of a, velocities of a k, forces of mu_a k a^2.
struct Snapshot {
  const Case& parameters;
  const TriangleMesh& mesh;
  const Points& reference;   ///< 3 x #V, the stress-free shape
  const Points& positions;   ///< 3 x #V
  const Points& velocities;  ///< 3 x #V
  const Points& forces;      ///< 3 x #V, by the membrane on the fluid, integrated over each vertex's share
  MotionSample motion;       ///< kt, deformation and angles, unwrapped
  int iterations = 0;        ///< of the flow solver since the last record
  double flow_error = 0;     ///< estimated relative error of the last flow solution
};

}  // namespace capstan
