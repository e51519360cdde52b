#pragma once
// Stabilised explicit time integration. A membrane is stiff: its short waves relax much faster than the flow
// deforms it, and they decay without oscillation. The second-order Runge-Kutta-Chebyshev method RKC2 of
// Sommeijer, Shampine and Verwer (J. Comput. Appl. Math. 88, 315, 1997) with s stages takes s flow solutions
// a step and is stable for decay rates up to about 0.65 s^2 / step.
#include "solver/case/rkc2_steps.hpp"
#include "solver/simulation/time_step.hpp"

namespace capstan {

class RungeKuttaChebyshev : public TimeStepper {
 public:
  struct Options {
    double tolerance = 3e-4;  ///< largest error of the positions in one step, root mean square, / a
    double largest_step = kRkc2Step;
    double soft_step = kRkc2SoftStep;
  };
  RungeKuttaChebyshev() : RungeKuttaChebyshev(Options{}) {}
  explicit RungeKuttaChebyshev(const Options& options) : options_(options) {}

  StepReport advance(const VelocityField& field, double kt, const Points& velocities,
                     Points& positions) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

  /// Of dU/dX, in units of k.
  double spectral_radius() const { return spectral_radius_; }

 private:
  /// The result of a step whose error has not been accepted yet.
  struct Trial {
    Points end, end_velocities;
    double error = 0;  ///< in units of the tolerance; not finite if a flow solution failed
  };
  double next_step() const;
  Trial attempt(double kt, double step, const Points& start, const Points& velocities);
  void estimate_spectral_radius(double kt, const Points& positions, const Points& velocities);
  bool has_stiffened_too_much() const;
  FlowReport solve(double kt, const Points& positions, Points& velocities);

  Options options_;
  const VelocityField* field_ = nullptr;  ///< during advance
  FlowReport report_;           ///< iterations of all flow solutions of this step, error of the last one
  double step_ = 0;             ///< k dt, length of the next step to be tried; 0 at the start of the run
  double spectral_radius_ = 0;  ///< of dU/dX, estimated; 0: not known
  double first_radius_ = 0;     ///< the first estimate of the run
  int steps_since_estimate_ = 0;
  Points stiffest_;  ///< 3 x #V, last estimate of the fastest decaying mode
};

}  // namespace capstan
