// The state of a simulation in a checkpoint: everything that the rest of the run depends on.
#include "solver/simulation/history_archive.hpp"
#include "solver/simulation/simulation.hpp"
#include "solver/state/points_archive.hpp"

namespace capstan {

StateArchive Simulation::state() const {
  StateArchive archive;
  archive.put("kt", now_.kt);
  put_points(archive, "positions", now_.positions);
  put_points(archive, "velocities", now_.velocities);
  archive.put("before/kt", before_.kt);
  put_points(archive, "before/positions", before_.positions);
  put_points(archive, "before/velocities", before_.velocities);
  stepper_->save(archive);
  flow_->save(archive);
  tracker_.save(archive);
  put_history(archive, history_);
  put_samples(archive, samples_);
  surface_.save(archive);
  archive.put("frames", frames_);
  archive.put("statistics", {double(statistics_.steps), double(statistics_.flow_iterations),
                             statistics_.worst_flow_error, statistics_.volume_drift, statistics_.area_drift});
  archive.put("iterations_since_record", iterations_since_record_);
  archive.put("last_flow_error", last_flow_error_);
  archive.put("refusals", refusals_);
  archive.put("recent_refusals", recent_refusals_);
  return archive;
}

void Simulation::load(const StateArchive& archive) {
  now_ = {archive.number("kt"), get_points(archive, "positions"), get_points(archive, "velocities"), {}};
  before_ = {archive.number("before/kt"),
             get_points(archive, "before/positions"),
             get_points(archive, "before/velocities"),
             {}};
  membrane_.forces(now_.positions, now_.forces);
  membrane_.forces(before_.positions, before_.forces);
  solved_ = now_;
  stepper_->load(archive);
  flow_->load(archive);
  tracker_.load(archive);
  history_ = get_history(archive);
  samples_ = get_samples(archive);
  surface_.load(archive);
  frames_ = int(archive.number("frames"));
  const auto saved = archive.get("statistics");
  statistics_ = {long(saved[0]), long(saved[1]), saved[2], saved[3], saved[4]};
  iterations_since_record_ = int(archive.number("iterations_since_record"));
  last_flow_error_ = archive.number("last_flow_error");
  refusals_ = int(archive.number("refusals"));
  recent_refusals_ = archive.number("recent_refusals");
}

}  // namespace capstan
