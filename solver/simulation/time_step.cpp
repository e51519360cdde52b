#include "solver/simulation/time_step.hpp"

#include "solver/state/points_archive.hpp"

namespace capstan {

// With r = step / (previous step):  x += step ((1 + r/2) u - r/2 u_before).  The previous step always has
// length kdt.
StepReport AdamsBashforth2::advance(const VelocityField&, double kt, double kt_end, const Points& velocities,
                                    Points& positions) {
  constexpr double kRounding = 1e-9;  // of a step: kt is a sum of steps, with rounding errors
  const bool is_last = kt_end - kt < kdt_ * (1 + kRounding);
  const double step = is_last ? kt_end - kt : kdt_, ratio = step / kdt_;
  if (before_.size() == 0) before_ = velocities;
  positions += step * ((1 + 0.5 * ratio) * velocities - 0.5 * ratio * before_);
  before_ = velocities;
  return {.kt = is_last ? kt_end : kt + step, .flow = {}};
}

void AdamsBashforth2::save(StateArchive& archive) const { put_points(archive, "time_step/before", before_); }

void AdamsBashforth2::load(const StateArchive& archive) { before_ = get_points(archive, "time_step/before"); }

}  // namespace capstan
