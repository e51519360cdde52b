#pragma once
// The interface between membrane and fluid: forces at the vertices in, velocities of the vertices out.
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class StateArchive;

/// Cost and accuracy of one solution of the flow.
struct FlowReport {
  int iterations = 0;  ///< multigrid cycles, lattice steps or matrix-vector products
  double error = 0;  ///< estimated relative error of the vertex velocities; infinite if no flow was computed
  bool converged = true;    ///< false: the velocities must not be used
  std::string reason = {};  ///< why it did not converge
};

/// The report of a flow that could not be computed.
inline FlowReport lost_flow(std::string reason) {
  return {.error = std::numeric_limits<double>::infinity(), .converged = false, .reason = std::move(reason)};
}

// Values of FlowReport::reason that several models use.
inline constexpr const char* kLostMembrane = "the membrane's positions or forces are not finite";
inline constexpr const char* kOutsideOfDomain =
    "the capsule has left the box: take a larger box, or the fluid stokes, which has none";

/// Flow around and inside one capsule in the shear flow u = (y, 0, 0). Units: a = k = mu_a = 1.
class FlowModel {
 public:
  virtual ~FlowModel() = default;

  /// Computes the velocities of the membrane at time kt.
  /// \param positions   3 x #V
  /// \param forces      3 x #V, by the membrane on the fluid, integrated over each vertex's share of the
  ///                    membrane
  /// \param velocities  3 x #V, result
  virtual FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) = 0;

  /// The time step k dt of the membrane, if the model prescribes it: the transient lattice prescribes its own
  /// time step.
  virtual std::optional<double> imposed_time_step() const { return std::nullopt; }

  /// Saves and loads everything the next solve depends on: a resumed run equals an uninterrupted one bit for
  /// bit.
  virtual void save(StateArchive& archive) const = 0;
  virtual void load(const StateArchive& archive) = 0;
};

}  // namespace capstan
