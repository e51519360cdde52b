#pragma once
// Stabilised explicit integration: a membrane is stiff (its short waves relax much faster than the flow turns
// it), and all its fast modes decay. RKC2 of Sommeijer, Shampine and Verwer (J. Comput. Appl. Math. 88, 315,
// 1997) is of second order and spends s flows on a step that is stable for decay rates up to about 0.65 s^2 /
// step.
#include "solver/simulation/time_step.hpp"

namespace capstan {

class RungeKuttaChebyshev : public TimeStepper {
 public:
  struct Options {
    double tolerance = 3e-4;    ///< largest error of one step, rms over the membrane / a
    double largest_step = 0.1;  ///< k dt
  };
  RungeKuttaChebyshev() : RungeKuttaChebyshev(Options{}) {}
  explicit RungeKuttaChebyshev(const Options& options) : options_(options) {}

  StepReport advance(const VelocityField& field, double kt, double kt_end, const Points& velocities,
                     Points& positions) override;
  void save(StateArchive& archive) const override;
  void load(const StateArchive& archive) override;

  double spectral_radius() const { return spectral_radius_; }

 private:
  /// One attempt: from (kt, start) with the velocities there by `step`.
  struct Trial {
    Points end, end_velocities;
    double error = 0;  ///< of the tolerance; not finite if the flow was lost
  };
  double next_step(double left) const;
  Trial attempt(double kt, double step, const Points& start, const Points& velocities);
  void estimate_spectral_radius(double kt, const Points& positions, const Points& velocities);
  bool has_stiffened_too_much() const;
  FlowReport solve(double kt, const Points& positions, Points& velocities);

  Options options_;
  const VelocityField* field_ = nullptr;  ///< during advance
  FlowReport report_;                     ///< of all flows since advance began
  double step_ = 0;                       ///< wished next; 0 at the start
  double spectral_radius_ = 0;            ///< of the velocities' derivative by the positions; 0: not known
  double first_radius_ = 0;               ///< the first estimate of it
  int steps_since_estimate_ = 0;
  Points stiffest_;  ///< 3 x #V: the mode that decays fastest, as last seen
};

}  // namespace capstan
