#include "solver/simulation/time_step.hpp"

#include "solver/state/points_archive.hpp"

namespace capstan {

FlowReport AdamsBashforth2::advance(const VelocityField&, double kt, double kt_end, const Points& velocities,
                                    Points& positions) {
  const double kdt = kt_end - kt;
  if (before_.size() == 0) before_ = velocities;
  positions += 0.5 * kdt * (3 * velocities - before_);
  before_ = velocities;
  return {};
}

void AdamsBashforth2::save(StateArchive& archive) const { put_points(archive, "time_step/before", before_); }

void AdamsBashforth2::load(const StateArchive& archive) { before_ = get_points(archive, "time_step/before"); }

}  // namespace capstan
