#pragma once
// The one interface between membrane and fluid: forces at the vertices in, velocities of the vertices out.
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class StateArchive;

/// What one solution of the flow cost, and how sure it is.
struct FlowReport {
  int iterations = 0;  ///< multigrid cycles, lattice steps or matrix-vector products
  double error = 0;    ///< estimated relative error of the vertex velocities; infinite when the flow is lost
  bool converged = true;   ///< false: the velocities are of no use
  std::string fault = {};  ///< why it did not converge
};

inline FlowReport lost_flow(std::string fault) {
  return {.error = std::numeric_limits<double>::infinity(), .converged = false, .fault = std::move(fault)};
}

/// The faults of every model.
inline constexpr const char* kLostMembrane = "the membrane's positions or forces are not finite";
inline constexpr const char* kOutsideOfDomain =
    "the capsule has left the box: take a larger box, or the fluid stokes, which has none";

/// Flow around (and inside) one capsule in the shear flow u = (y, 0, 0). Units: a = k = mu_a = 1.
class FlowModel {
 public:
  virtual ~FlowModel() = default;

  /// Velocities of the membrane at time kt, for its positions and its forces on the fluid.
  /// \param positions  3 x #V   \param forces  3 x #V, integrated over the vertex's share of the membrane
  /// \param velocities 3 x #V, result
  virtual FlowReport solve(double kt, const Points& positions, const Points& forces, Points& velocities) = 0;

  /// The time step k*dt this model imposes, if it does (a transient lattice model steps with its lattice).
  virtual std::optional<double> imposed_time_step() const { return std::nullopt; }

  /// Everything the next solve depends on, so that a resumed run equals an uninterrupted one to the last bit.
  virtual void save(StateArchive& archive) const = 0;
  virtual void load(const StateArchive& archive) = 0;
};

}  // namespace capstan
