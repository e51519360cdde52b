#include "solver/simulation/runge_kutta_chebyshev.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/rkc2_steps.hpp"
#include "solver/state/points_archive.hpp"

namespace capstan {
namespace {

constexpr double kDamping = 2. / 13;  // epsilon: a step multiplies fast modes by factors of 1/3 to 0.95
constexpr int kStepsAnEstimate = 15;
constexpr int kMaxStages = 200;
constexpr double kMinStep = 1e-6;

double rms(const Points& vectors) { return vectors.norm() / std::sqrt(double(vectors.cols())); }

/// Chebyshev polynomial T_j and its first two derivatives at w0, by their recurrence.
struct Chebyshev {
  double T, dT, ddT;
};
Chebyshev next(double w0, const Chebyshev& now, const Chebyshev& before) {
  return {2 * w0 * now.T - before.T, 2 * now.T + 2 * w0 * now.dT - before.dT,
          4 * now.dT + 2 * w0 * now.ddT - before.ddT};
}

/// The coefficients of a step of s stages, in the symbols of Sommeijer et al.
struct Coefficients {
  explicit Coefficients(int s) {
    const double w0 = 1 + kDamping / (s * s);
    std::vector<Chebyshev> c{{1, 0, 0}, {w0, 1, 0}};
    for (int j = 2; j <= s; ++j) c.push_back(next(w0, c[j - 1], c[j - 2]));
    const double w1 = c[s].dT / c[s].ddT;
    std::vector<double> b(s + 1), a(s + 1), time(s + 1);
    for (int j = 2; j <= s; ++j) b[j] = c[j].ddT / (c[j].dT * c[j].dT);
    b[0] = b[1] = b[2];
    for (int j = 0; j <= s; ++j) a[j] = 1 - b[j] * c[j].T;
    for (int j = 2; j <= s; ++j) time[j] = w1 * c[j].ddT / c[j].dT;
    time[1] = time[2] / c[2].dT;
    first = b[1] * w1;
    for (int j = 2; j <= s; ++j)
      stages.push_back({.mu = 2 * b[j] * w0 / b[j - 1],
                        .nu = -b[j] / b[j - 2],
                        .mu_tilde = 2 * b[j] * w1 / b[j - 1],
                        .gamma_tilde = -a[j - 1] * 2 * b[j] * w1 / b[j - 1],
                        .time_before = time[j - 1]});
  }
  struct Stage {
    double mu, nu, mu_tilde, gamma_tilde;
    double time_before;  ///< c_(j-1), in steps
  };
  double first;               ///< mu_tilde_1
  std::vector<Stage> stages;  ///< j = 2 .. s
};

}  // namespace

StepReport RungeKuttaChebyshev::advance(const VelocityField& field, double kt, const Points& velocities,
                                        Points& positions) {
  field_ = &field;
  report_ = {};
  if (step_ == 0) step_ = options_.largest_step / 10;
  int refusals = 0;
  do {
    if (spectral_radius_ == 0 || steps_since_estimate_ >= kStepsAnEstimate)
      estimate_spectral_radius(kt, positions, velocities);
    if (has_stiffened_too_much())
      return {.kt = kt,
              .flow = lost_flow("the membrane has become thousands of times as stiff as it was"),
              .refusals = refusals};
    const double step = next_step();
    Trial trial = attempt(kt, step, positions, velocities);
    const double factor =
        std::isfinite(trial.error) ? std::clamp(0.8 / std::cbrt(trial.error), 0.1, 3.) : 0.1;
    if (trial.error <= 1) {
      positions = std::move(trial.end);
      ++steps_since_estimate_;
      step_ = std::min(std::max(options_.largest_step, options_.soft_step),
                       std::max(step * factor, factor >= 1 ? step_ : 0.));
      report_.converged = true;  // flow solutions that failed were repeated with a smaller step
      return {.kt = kt + step, .flow = report_, .refusals = refusals};
    }
    ++refusals;
    step_ = step * factor;
    spectral_radius_ = 0;  // an underestimated radius is the likely cause of the error: estimate it again
  } while (step_ >= kMinStep);
  if (report_.converged) report_ = lost_flow("no time step is small enough for the membrane's motion");
  return {.kt = kt, .flow = report_, .refusals = refusals};
}

/// The longest step that error and stability allow.
double RungeKuttaChebyshev::next_step() const {
  const double accurate = longest_rkc2_step(spectral_radius_, options_.largest_step, options_.soft_step);
  return std::min({step_, accurate, kMaxStages * kMaxStages / (1.6 * spectral_radius_)});
}

RungeKuttaChebyshev::Trial RungeKuttaChebyshev::attempt(double kt, double step, const Points& start,
                                                        const Points& velocities) {
  const Coefficients coefficients(rkc2_stages(step, spectral_radius_));
  Trial trial;
  Points before = start, now = start + coefficients.first * step * velocities,
         stage_velocities(3, start.cols());
  for (const Coefficients::Stage& stage : coefficients.stages) {
    if (!solve(kt + stage.time_before * step, now, stage_velocities).converged)
      return {.end = {}, .end_velocities = {}, .error = INFINITY};
    Points after = (1 - stage.mu - stage.nu) * start + stage.mu * now + stage.nu * before +
                   step * (stage.mu_tilde * stage_velocities + stage.gamma_tilde * velocities);
    before = std::exchange(now, std::move(after));
  }
  trial.end = std::move(now);
  trial.end_velocities.resize(3, start.cols());
  if (!solve(kt + step, trial.end, trial.end_velocities).converged)
    trial.error = INFINITY;
  else
    trial.error = rms(0.8 * (start - trial.end) + 0.4 * step * (velocities + trial.end_velocities)) /
                  options_.tolerance;
  return trial;
}

// Power iteration on dU/dX. Its products with vectors are finite differences of the velocities; the start is
// the mode of the last estimate.
void RungeKuttaChebyshev::estimate_spectral_radius(double kt, const Points& positions,
                                                   const Points& velocities) {
  constexpr double kDisplacement = 1e-4;  // root mean square displacement / a: far above the rounding error
                                          // of the flow, far below an edge length
  constexpr int kMaxIterations = 50;
  constexpr double kEnough = 0.02;  // relative change from one iteration to the next
  if (stiffest_.size() == 0) stiffest_ = velocities;
  double radius = 0;
  Points displaced_velocities(3, positions.cols());
  for (int n = 0; n < kMaxIterations; ++n) {
    stiffest_ *= kDisplacement / rms(stiffest_);
    if (!solve(kt, positions + stiffest_, displaced_velocities).converged) break;
    stiffest_ = displaced_velocities - velocities;
    const double last = std::exchange(radius, rms(stiffest_) / kDisplacement);
    if (n > 0 && std::abs(radius - last) <= kEnough * radius) break;
  }
  spectral_radius_ = std::max(kRkc2Safety * radius, 1.);
  if (first_radius_ == 0) first_radius_ = spectral_radius_;
  steps_since_estimate_ = 0;
}

/// Whether the run should stop because the membrane has become too stiff. Collapsing triangles make it
/// stiffer without limit, and at a spectral radius of 1e6 a unit of kt takes thousands of flow solutions. A
/// membrane that is that stiff from the start on does not stop the run.
bool RungeKuttaChebyshev::has_stiffened_too_much() const {
  constexpr double kGrowth = 1e4, kRadius = 1e6;
  return spectral_radius_ > std::max(kRadius, kGrowth * first_radius_);
}

FlowReport RungeKuttaChebyshev::solve(double kt, const Points& positions, Points& velocities) {
  const FlowReport one = (*field_)(kt, positions, velocities);
  report_.iterations += one.iterations;
  report_.error = one.error;
  report_.converged = one.converged;
  report_.reason = one.reason;
  return one;
}

void RungeKuttaChebyshev::save(StateArchive& archive) const {
  archive.put("time_step/step", {step_, spectral_radius_, first_radius_, double(steps_since_estimate_)});
  put_points(archive, "time_step/stiffest", stiffest_);
}

void RungeKuttaChebyshev::load(const StateArchive& archive) {
  const auto saved = archive.get("time_step/step");
  step_ = saved[0], spectral_radius_ = saved[1], first_radius_ = saved[2],
  steps_since_estimate_ = int(saved[3]);
  stiffest_ = get_points(archive, "time_step/stiffest");
}

}  // namespace capstan
