#include "solver/simulation/time_step.hpp"

#include "solver/state/points_archive.hpp"

namespace capstan {

StepReport AdamsBashforth2::advance(const VelocityField&, double kt, const Points& velocities,
                                    Points& positions) {
  if (before_.size() == 0) before_ = velocities;
  positions += kdt_ * (1.5 * velocities - 0.5 * before_);
  before_ = velocities;
  return {.kt = kt + kdt_, .flow = {}};
}

void AdamsBashforth2::save(StateArchive& archive) const { put_points(archive, "time_step/before", before_); }

void AdamsBashforth2::load(const StateArchive& archive) { before_ = get_points(archive, "time_step/before"); }

}  // namespace capstan
