#pragma once
// Time integration of the membrane, which moves with the fluid: dX/dt = U(X, t) (paper eq. 37).
#include <functional>

#include "solver/fluid/flow_model.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// U(X, t): the velocities of the membrane (3 x #V) in the flow that its forces drive at these positions and
/// time.
using VelocityField = std::function<FlowReport(double kt, const Points& positions, Points& velocities)>;

struct StepReport {
  double kt;        ///< at the end of the step
  FlowReport flow;  ///< iterations of all flow solutions of the step; error of the last one; not converged if
                    ///< no step was made
  int refusals = 0;  ///< attempts that were rejected because their error was too large
};

class TimeStepper {
 public:
  virtual ~TimeStepper() = default;

  /// Moves the membrane by one step from kt. The step does not depend on the end of the run.
  /// \param velocities 3 x #V, of the membrane at the start   \param positions 3 x #V, in and out
  virtual StepReport advance(const VelocityField& field, double kt, const Points& velocities,
                             Points& positions) = 0;

  /// All state that the next call of advance() depends on.
  virtual void save(StateArchive& archive) const = 0;
  virtual void load(const StateArchive& archive) = 0;
};

/// Second-order Adams-Bashforth (paper eq. 38); the first step is Euler's. All steps have length kdt. A step
/// uses only the flow at its start.
class AdamsBashforth2 : public TimeStepper {
 public:
  explicit AdamsBashforth2(double kdt) : kdt_(kdt) {}

  StepReport advance(const VelocityField& field, double kt, const Points& velocities,
                     Points& positions) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

 private:
  double kdt_;
  Points before_;  ///< 3 x #V, velocities at the start of the previous step; empty at the start of the run
};

}  // namespace capstan
