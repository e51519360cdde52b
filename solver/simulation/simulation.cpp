#include "solver/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "solver/mesh/geometry.hpp"
#include "solver/mesh/shapes.hpp"
#include "solver/simulation/history_archive.hpp"
#include "solver/state/points_archive.hpp"

namespace capstan {

// Paper, section VI: at each step the membrane's forces drive a steady flow, and the membrane moves with that
// flow.
Outcome Simulation::run(RunOutput& output) {
  const VelocityField field = [this](double at, const Points& x, Points& u) { return solve_flow(at, x, u); };
  for (;;) {
    const FlowReport flow = solve_flow(kt(), positions_, velocities_);
    if (auto outcome = failure(flow)) return *outcome;
    note(flow);
    if (record_is_due()) record(output);  // eqs. 5, 44
    if (auto outcome = finished()) return *outcome;
    const FlowReport stages = stepper_->advance(field, kt(), kt(1), velocities_, positions_);  // eqs. 37, 38
    if (auto outcome = failure(stages)) return *outcome;
    note(stages);
    ++statistics_.steps;
    const bool interrupted = output.interrupted();
    if (interrupted || statistics_.steps % case_.outputs.checkpoint_every == 0) save_checkpoint(output);
    if (interrupted) return {Stop::interrupted};
  }
}

/// A stepper may end with the flow that the next step starts with: that one is known.
FlowReport Simulation::solve_flow(double at, const Points& positions, Points& velocities) {
  if (positions == solved_.positions) {
    velocities = solved_.velocities;
    return {};
  }
  membrane_.forces(positions, forces_);                                      // eqs. 29, 31
  const FlowReport flow = flow_->solve(at, positions, forces_, velocities);  // eqs. 20-25, 33-36, 40
  if (flow.converged) solved_ = {positions, velocities};
  return flow;
}

Simulation::Simulation(const Case& c)
    : case_(c),
      sphere_(make_icosphere(*icosphere_subdivisions(c.fidelity.nodes))),
      positions_(initial_positions(c, sphere_)),
      forces_(Points::Zero(3, positions_.cols())),
      velocities_(Points::Zero(3, positions_.cols())),
      solved_{Points::Zero(3, positions_.cols()), velocities_},
      orbits_(symmetry_of(c, positions_)),
      membrane_(c, sphere_.mesh, positions_, orbits_),
      flow_(make_flow(c, sphere_.mesh, positions_, orbits_)),
      stepper_(make_stepper(c)),
      time_(c, flow_->imposed_time_step()),
      tracker_(positions_, sphere_.mesh.faces),
      initial_volume_(volume(positions_, faces())),
      initial_area_(area(positions_, faces())) {}

TimeGrid::TimeGrid(const Case& c, std::optional<double> imposed_kdt)
    : kdt(imposed_kdt.value_or(c.fidelity.kdt > 0 ? c.fidelity.kdt
                                                  : std::min(c.outputs.history_every, c.until.kt))),
      steps(std::max(1L, std::lround(c.until.kt / kdt))),
      steps_a_record(std::max(1L, std::lround(c.outputs.history_every / kdt))) {
  const double record_kt = kdt * double(steps_a_record);
  if (c.outputs.shapes_every > 0)
    steps_a_shape = steps_a_record * std::max(1L, std::lround(c.outputs.shapes_every / record_kt));
}

/// Rounded, so that a history says 0.3 and not 0.30000000000000004.
double Simulation::kt(int steps_ahead) const {
  return std::round(double(statistics_.steps + steps_ahead) * time_.kdt * 1e9) / 1e9;
}

std::optional<Outcome> Simulation::failure(const FlowReport& flow) const {
  const auto at_this_time = [&](const std::string& what) {
    std::ostringstream text;
    text << "at kt = " << kt() << ": " << what;
    return text.str();
  };
  for (Eigen::Index vertex = 0; vertex < positions_.cols(); ++vertex)
    if (!positions_.col(vertex).allFinite())
      return Outcome{Stop::diverged,
                     at_this_time("vertex " + std::to_string(vertex) + " has no finite position")};
  if (!flow.converged)
    return Outcome{std::isfinite(flow.error) ? Stop::not_converged : Stop::diverged,
                   at_this_time(flow.fault)};
  constexpr double kLargestDrift = 0.1;  // the first symptom of a time step that is too large
  const double drift = volume(positions_, faces()) / initial_volume_ - 1;
  if (!(std::abs(drift) < kLargestDrift))
    return Outcome{Stop::diverged,
                   at_this_time("the volume has drifted by " + std::to_string(std::lround(100 * drift)) +
                                " %; try a smaller kdt or dx")};
  return std::nullopt;
}

void Simulation::note(const FlowReport& flow) {
  iterations_since_record_ += flow.iterations;
  statistics_.flow_iterations += flow.iterations;
  if (flow.iterations > 0) last_flow_error_ = flow.error;
  statistics_.worst_flow_error = std::max(statistics_.worst_flow_error, flow.error);
}

bool Simulation::record_is_due() const {
  return statistics_.steps % time_.steps_a_record == 0 || statistics_.steps == time_.steps;
}

void Simulation::record(RunOutput& output) {
  Record now = tracker_.observe(kt(), positions_);
  now.iterations = std::exchange(iterations_since_record_, 0);
  now.error = last_flow_error_;
  history_.push_back(now);
  statistics_.volume_drift = std::max(statistics_.volume_drift, std::abs(now.volume / initial_volume_ - 1));
  statistics_.area_drift = std::max(statistics_.area_drift, std::abs(now.area / initial_area_ - 1));
  output.record(now);
  if (time_.steps_a_shape > 0 && statistics_.steps % time_.steps_a_shape == 0)
    output.shape(kt(), int(statistics_.steps / time_.steps_a_shape), positions_, velocities_, forces_);
}

std::optional<Outcome> Simulation::finished() const {
  if (statistics_.steps >= time_.steps) return Outcome{Stop::reached_end};
  if (case_.until.classified && record_is_due() && classify(history_).certain)
    return Outcome{Stop::classified};
  return std::nullopt;
}

void Simulation::save_checkpoint(RunOutput& output) const {
  StateArchive archive;
  put_points(archive, "positions", positions_);
  put_points(archive, "solved/positions", solved_.positions);
  put_points(archive, "solved/velocities", solved_.velocities);
  stepper_->save(archive);
  flow_->save(archive);
  tracker_.save(archive);
  put_history(archive, history_);
  archive.put("statistics", {double(statistics_.steps), double(statistics_.flow_iterations),
                             statistics_.worst_flow_error, statistics_.volume_drift, statistics_.area_drift});
  archive.put("iterations_since_record", iterations_since_record_);
  archive.put("last_flow_error", last_flow_error_);
  output.checkpoint(std::move(archive));
}

void Simulation::load(const StateArchive& archive) {
  positions_ = get_points(archive, "positions");
  solved_ = {get_points(archive, "solved/positions"), get_points(archive, "solved/velocities")};
  membrane_.forces(positions_, forces_);
  stepper_->load(archive);
  flow_->load(archive);
  tracker_.load(archive);
  history_ = get_history(archive);
  const auto saved = archive.get("statistics");
  statistics_ = {long(saved[0]), long(saved[1]), saved[2], saved[3], saved[4]};
  iterations_since_record_ = int(archive.number("iterations_since_record"));
  last_flow_error_ = archive.number("last_flow_error");
}

}  // namespace capstan
