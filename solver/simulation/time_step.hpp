#pragma once
// Moving the membrane with the fluid: dX/dt = U(X, t) (paper eq. 37).
#include <functional>

#include "solver/fluid/flow_model.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// Velocities of a membrane that is at `positions` at time kt: its forces, and the flow they drive.
using VelocityField = std::function<FlowReport(double kt, const Points& positions, Points& velocities)>;

/// Where a step ended, and the flows it solved on the way; not converged when there was no step.
struct StepReport {
  double kt;
  FlowReport flow;
  int refusals = 0;  ///< attempts whose error was too large
};

class TimeStepper {
 public:
  virtual ~TimeStepper() = default;

  /// Moves the membrane by one step from kt, not beyond kt_end.
  /// \param velocities 3 x #V, of the membrane at the start   \param positions 3 x #V, in and out
  virtual StepReport advance(const VelocityField& field, double kt, double kt_end, const Points& velocities,
                             Points& positions) = 0;

  /// Everything the next advance depends on.
  virtual void save(StateArchive& archive) const = 0;
  virtual void load(const StateArchive& archive) = 0;
};

/// Second-order Adams-Bashforth (paper eq. 38), with one Euler step to start. Steps are equal but for the
/// last one, which ends at kt_end; it needs no flow but the one at the start.
class AdamsBashforth2 : public TimeStepper {
 public:
  explicit AdamsBashforth2(double kdt) : kdt_(kdt) {}

  StepReport advance(const VelocityField& field, double kt, double kt_end, const Points& velocities,
                     Points& positions) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  double kdt_;
  Points before_;  ///< velocities of the step before; empty at the start
};

}  // namespace capstan
