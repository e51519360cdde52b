#include "solver/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "solver/case/flow_rounding.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/shapes.hpp"
#include "solver/mesh/surface_quality.hpp"
#include "solver/simulation/history_archive.hpp"
#include "solver/simulation/remedy.hpp"
#include "solver/state/points_archive.hpp"

namespace capstan {

// Paper, section VI: at each step the membrane's forces drive a steady flow, and the membrane moves with that
// flow.
Outcome Simulation::run(RunOutput& output) {
  std::optional<Outcome> breakdown;
  if (history_.empty()) {
    breakdown = find_flow();
    if (!breakdown) put_out(output);
  }
  while (!breakdown) {
    breakdown = step();
    if (breakdown) break;
    put_out(output);
    if (auto outcome = finished(output)) return *outcome;
    const bool interrupted = output.interrupted();
    if (interrupted || output.is_checkpoint_due(statistics_.steps)) save_checkpoint(output);
    if (interrupted) return {Stop::interrupted};
  }
  show_breakdown(output);
  return *breakdown;
}

/// A lattice in time has steps of one length: its last one goes beyond the end.
std::optional<Outcome> Simulation::step() {
  const VelocityField field = [this](double at, const Points& x, Points& u) { return solve_flow(at, x, u); };
  const double end = flow_->imposed_time_step() ? std::numeric_limits<double>::infinity() : case_.until.kt;
  before_ = now_;
  const StepReport step =
      stepper_->advance(field, before_.kt, end, before_.velocities, now_.positions);  // eqs. 37, 38
  now_.kt = step.kt;
  if (auto outcome = failure(step.flow)) return outcome;
  if (auto outcome = refusal(step)) return outcome;
  note(step.flow);
  ++statistics_.steps;
  return find_flow();
}

std::optional<Outcome> Simulation::find_flow() {
  const FlowReport flow = solve_flow(now_.kt, now_.positions, now_.velocities);
  if (auto outcome = failure(flow)) return outcome;
  note(flow);
  now_.forces = solved_.forces;
  return std::nullopt;
}

/// A stepper may end with the flow that the next step starts with: that one is known.
FlowReport Simulation::solve_flow(double at, const Points& positions, Points& velocities) {
  if (positions == solved_.positions) {
    velocities = solved_.velocities;
    return {};
  }
  Points forces(3, positions.cols());
  membrane_.forces(positions, forces);                                      // eqs. 29, 31
  const FlowReport flow = flow_->solve(at, positions, forces, velocities);  // eqs. 20-25, 33-36, 40
  if (flow.converged) solved_ = {at, positions, velocities, forces};
  return flow;
}

Simulation::Simulation(const Case& c)
    : case_(c),
      sphere_(make_icosphere(*icosphere_subdivisions(c.fidelity.nodes))),
      now_{.kt = 0, .positions = initial_positions(c, sphere_), .velocities = {}, .forces = {}},
      orbits_(symmetry_of(c, now_.positions)),
      membrane_(c, sphere_.mesh, now_.positions, orbits_),
      flow_(make_flow(c, sphere_.mesh, now_.positions, orbits_)),
      stepper_(make_stepper(c, flow_->imposed_time_step())),
      record_times_(c.outputs.history_every, c.until.kt),
      tracker_(now_.positions, sphere_.mesh.faces),
      initial_volume_(volume(now_.positions, faces())),
      initial_area_(area(now_.positions, faces())) {
  now_.velocities = now_.forces = Points::Zero(3, now_.positions.cols());
  solved_ = {0, Points::Zero(3, now_.positions.cols()), now_.velocities, now_.forces};
  if (c.outputs.shapes_every > 0) shape_times_.emplace(c.outputs.shapes_every, c.until.kt);
}

std::optional<Outcome> Simulation::failure(const FlowReport& flow) const {
  if (!flow.converged)
    return stopped(std::isfinite(flow.error) ? Stop::not_converged : Stop::diverged, flow.reason);
  if (!now_.positions.allFinite()) return stopped(Stop::diverged, "a position of the membrane is not finite");
  constexpr double kMaxDrift = 0.1;  // the first symptom of a time step that is too large
  const double drift = volume(now_.positions, faces()) / initial_volume_ - 1;
  if (!(std::abs(drift) < kMaxDrift)) return stopped(Stop::diverged, volume_drift_in_words(drift));
  return std::nullopt;
}

/// On a surface that is lost a step that is refused shrinks without end, and the flow costs ever more. On any
/// other a run whose steps are refused again and again within one unit of kt would take for ever.
std::optional<Outcome> Simulation::refusal(const StepReport& step) {
  constexpr int kMaxOnLostSurface = 20;
  constexpr double kMaxRecent = 100;  // stiff membranes that reach their end have up to 40
  if (step.refusals > 0 && is_lost(surface_quality(sphere_.mesh, now_.positions))) refusals_ += step.refusals;
  recent_refusals_ = recent_refusals_ * std::exp(before_.kt - now_.kt) + step.refusals;
  if (refusals_ <= kMaxOnLostSurface && recent_refusals_ <= kMaxRecent) return std::nullopt;
  return stopped(Stop::diverged, "the steps become ever shorter");
}

/// \param what has gone wrong; when, and what to do, are added
Outcome Simulation::stopped(Stop stop, const std::string& what) const {
  std::ostringstream text;
  text << "at kt = " << now_.kt << ": " << what;
  const std::string advice =
      remedy(case_, surface_quality(sphere_.mesh, now_.positions), stop == Stop::diverged);
  if (!advice.empty()) text << ". " << advice;
  return {stop, text.str()};
}

/// No flow is better than its numbers.
void Simulation::note(const FlowReport& flow) {
  const double error = std::max(flow.error, flow_rounding(case_));
  iterations_since_record_ += flow.iterations;
  statistics_.flow_iterations += flow.iterations;
  if (flow.iterations > 0) last_flow_error_ = error;
  statistics_.worst_flow_error = std::max(statistics_.worst_flow_error, error);
}

/// The last sound state, if there was one, as a record and a shape; and as a shape what came of it.
void Simulation::show_breakdown(RunOutput& output) {
  if (!history_.empty()) {
    if (history_.back().kt < before_.kt) record(before_, output);
    if (!is_shown(before_.kt)) show(before_, output);
    if (now_.kt == before_.kt) return;  // no step could be made
  }
  if (now_.positions.allFinite()) membrane_.forces(now_.positions, now_.forces);
  show(now_, output);
}

bool Simulation::is_shown(double time) const { return shape_times_ && (*shape_times_)[frames_ - 1] >= time; }

void Simulation::show(const MembraneState& state, RunOutput& output) {
  output.shape(state.kt, frames_++, state.positions, state.velocities, state.forces);
}

/// Everything that was asked for since the step before, and a sample.
void Simulation::put_out(RunOutput& output) {
  for (long n = long(history_.size()); n <= record_times_.last() && has_come(record_times_[n]); ++n)
    record(state_at(record_times_[n]), output);  // eqs. 5, 44
  while (shape_times_ && frames_ <= shape_times_->last() && has_come((*shape_times_)[frames_]))
    show(state_at((*shape_times_)[frames_]), output);
  observe();
}

constexpr double kSameTime = 1e-6;  ///< of a step: nearer to its end than this is at its end

bool Simulation::has_come(double time) const { return time <= now_.kt + kSameTime * (now_.kt - before_.kt); }

MembraneState Simulation::state_at(double time) const {
  if (time < now_.kt - kSameTime * (now_.kt - before_.kt)) return between(before_, now_, time);
  MembraneState state = now_;
  state.kt = time;
  return state;
}

void Simulation::record(const MembraneState& state, RunOutput& output) {
  Record now = tracker_.look(state.kt, state.positions);
  now.iterations = std::exchange(iterations_since_record_, 0);
  now.error = last_flow_error_;
  history_.push_back(now);
  output.record(now);
}

void Simulation::observe() {
  const bool is_due = samples_.empty() || has_come(samples_.back().kt + kSampleInterval);
  if (!is_due && now_.kt < case_.until.kt) return;
  const Record seen = tracker_.observe(now_.kt, now_.positions);
  samples_.push_back({seen.kt, seen.D_xy, seen.theta, seen.psi});
  statistics_.volume_drift = std::max(statistics_.volume_drift, std::abs(seen.volume / initial_volume_ - 1));
  if (surface_.is_due(now_.kt)) surface_.look(now_.kt, surface_quality(sphere_.mesh, now_.positions));
  statistics_.area_drift = std::max(statistics_.area_drift, std::abs(seen.area / initial_area_ - 1));
}

Verdict Simulation::verdict() const { return judged_on(surface_, classify(samples_)); }

/// Whether to end early is asked each time that kt has grown by a hundredth: an answer takes time that grows
/// with the length of the run.
std::optional<Outcome> Simulation::finished(RunOutput& output) {
  if (now_.kt >= case_.until.kt) return Outcome{Stop::reached_end};
  const auto hundredths = [](double kt) { return std::floor(std::log(kt) / 0.01); };
  if (!case_.until.classified || hundredths(now_.kt) == hundredths(before_.kt)) return std::nullopt;
  const Verdict label = verdict();
  if (!label.steady && !label.certain) return std::nullopt;
  if (history_.back().kt < now_.kt) record(now_, output);
  if (shape_times_ && !is_shown(now_.kt)) show(now_, output);
  return Outcome{label.steady ? Stop::steady : Stop::classified};
}

void Simulation::save_checkpoint(RunOutput& output) const {
  StateArchive archive;
  archive.put("kt", now_.kt);
  put_points(archive, "positions", now_.positions);
  put_points(archive, "velocities", now_.velocities);
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
  output.checkpoint(std::move(archive));
}

void Simulation::load(const StateArchive& archive) {
  now_ = {archive.number("kt"), get_points(archive, "positions"), get_points(archive, "velocities"), {}};
  membrane_.forces(now_.positions, now_.forces);
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
