#include "solver/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "solver/case/flow_rounding.hpp"
#include "solver/mesh/geometry.hpp"
#include "solver/mesh/shapes.hpp"
#include "solver/mesh/surface_quality.hpp"
#include "solver/observe/measure.hpp"
#include "solver/simulation/plan.hpp"
#include "solver/simulation/remedy.hpp"

namespace capstan {

// Paper, section VI: at each step the forces of the membrane drive a steady flow, and the membrane moves with
// it.
Outcome Simulation::run(RunOutput& output) {
  std::optional<Outcome> breakdown;
  if (history_.empty()) breakdown = solve_flow_now();
  if (!breakdown)  // the last state of a shorter run lacks output of this one
    if (auto outcome = observe(output)) return *outcome;
  while (!breakdown) {
    breakdown = step();
    if (breakdown) break;
    if (auto outcome = observe(output)) return *outcome;
    const bool interrupted = output.interrupted();
    if (interrupted || output.is_checkpoint_due(statistics_.steps)) output.checkpoint(state());
    if (interrupted) return {Stop::interrupted};
  }
  write_breakdown(output);
  return *breakdown;
}

/// Steps do not depend on the end of the run: the last one passes it.
std::optional<Outcome> Simulation::step() {
  const VelocityField field = [this](double at, const Points& x, Points& u) { return solve_flow(at, x, u); };
  before_ = now_;
  const StepReport step =
      stepper_->advance(field, before_.kt, before_.velocities, now_.positions);  // eqs. 37, 38
  now_.kt = step.kt;
  if (auto outcome = failure(step.flow)) return outcome;
  if (auto outcome = refusal(step)) return outcome;
  count(step.flow);
  count_drift();
  ++statistics_.steps;
  return solve_flow_now();
}

std::optional<Outcome> Simulation::solve_flow_now() {
  const FlowReport flow = solve_flow(now_.kt, now_.positions, now_.velocities);
  if (auto outcome = failure(flow)) return outcome;
  count(flow);
  now_.forces = solved_.forces;
  return std::nullopt;
}

/// If the positions are those of the last flow solution, it is reused: a step of some steppers ends with the
/// solution with which the next step starts.
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
      sphere_(icosphere_with(c.fidelity.nodes)),
      reference_(initial_positions(c, sphere_)),
      now_{.kt = 0, .positions = reference_, .velocities = {}, .forces = {}},
      orbits_(symmetry_of(c, reference_)),
      membrane_(c, sphere_.mesh, reference_, orbits_),
      flow_(make_flow(c, sphere_.mesh, reference_, orbits_)),
      stepper_(make_stepper(c, flow_->imposed_time_step())),
      record_times_(c.outputs.history_every),
      tracker_(reference_, faces()),
      initial_volume_(volume(reference_, faces())),
      initial_area_(area(reference_, faces())) {
  now_.velocities = now_.forces = Points::Zero(3, now_.positions.cols());
  solved_ = {0, Points::Zero(3, now_.positions.cols()), now_.velocities, now_.forces};
  if (c.outputs.shapes_every > 0) shape_times_.emplace(c.outputs.shapes_every);
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

/// Stops runs that make no progress. If the mesh does not resolve the surface, steps are rejected and
/// shortened without limit, and the cost of a flow solution grows. On a resolved surface, a run with hundreds
/// of rejected steps in one unit of kt would not end in reasonable time.
std::optional<Outcome> Simulation::refusal(const StepReport& step) {
  constexpr int kMaxOnLostSurface = 20;
  constexpr double kMaxRecent = 100;  // stiff membranes that reach the end of the run have up to 40
  if (step.refusals > 0 && is_lost(surface_quality(sphere_.mesh, now_.positions))) refusals_ += step.refusals;
  recent_refusals_ = recent_refusals_ * std::exp(before_.kt - now_.kt) + step.refusals;
  if (refusals_ <= kMaxOnLostSurface && recent_refusals_ <= kMaxRecent) return std::nullopt;
  return stopped(Stop::diverged, "the steps become ever shorter");
}

/// \param what  the failure in words; the time and advice to the user are added to it
Outcome Simulation::stopped(Stop stop, const std::string& what) const {
  std::ostringstream text;
  text << "at kt = " << now_.kt << ": " << what;
  const std::string advice =
      remedy(case_, surface_quality(sphere_.mesh, now_.positions), stop == Stop::diverged);
  if (!advice.empty()) text << ". " << advice;
  return {stop, text.str()};
}

/// Adds the present state to the statistics.
void Simulation::count_drift() {
  const auto drift = [](double now, double initial) { return std::abs(now / initial - 1); };
  statistics_.volume_drift =
      std::max(statistics_.volume_drift, drift(volume(now_.positions, faces()), initial_volume_));
  statistics_.area_drift =
      std::max(statistics_.area_drift, drift(area(now_.positions, faces()), initial_area_));
}

/// Adds a flow solution to the statistics. Its error is at least the rounding error of the flow model.
void Simulation::count(const FlowReport& flow) {
  const double error = std::max(flow.error, flow_rounding(case_));
  iterations_since_record_ += flow.iterations;
  statistics_.flow_iterations += flow.iterations;
  if (flow.iterations > 0) last_flow_error_ = error;
  statistics_.worst_flow_error = std::max(statistics_.worst_flow_error, error);
}

/// Writes a record and a shape of the last valid state, if there is one, and a shape of the invalid state.
void Simulation::write_breakdown(RunOutput& output) {
  if (!history_.empty()) {
    if (history_.back()["kt"] < before_.kt) record(before_, output);
    if (!has_shape_at(before_.kt)) write_shape(before_, output);
    if (now_.kt == before_.kt) return;  // no step could be made
  }
  if (now_.positions.allFinite()) membrane_.forces(now_.positions, now_.forces);
  write_shape(now_, output);
}

constexpr double kRounding = 1e-12;  // relative error of a multiple of an interval

bool Simulation::has_record_at(double kt) const { return history_.back()["kt"] >= kt * (1 - kRounding); }

bool Simulation::has_shape_at(double kt) const {
  return shape_times_ && (*shape_times_)[frames_ - 1] >= kt * (1 - kRounding);
}

void Simulation::write_shape(const MembraneState& state, RunOutput& output) {
  output.shape(state.kt, frames_++, state.positions, state.velocities, state.forces);
}

/// Writes the output of the last step, and decides whether it was the last one of the run.
std::optional<Outcome> Simulation::observe(RunOutput& output) {
  const Until& until = case_.until;
  write_output_to(passes(until.kt) ? until.kt : until.last(), output);
  sample_motion();
  if (auto outcome = finished(output)) return outcome;
  write_output_to(until.last(), output);
  return std::nullopt;
}

/// Writes the records and shapes whose times were passed by the last step, if they are not after `end`.
void Simulation::write_output_to(double end, RunOutput& output) {
  const auto is_due = [&](double kt) { return kt <= end && is_reached(kt); };
  for (long n = long(history_.size()); is_due(record_times_[n]); ++n)
    record(state_at(record_times_[n]), output);  // eqs. 5, 44
  while (shape_times_ && is_due((*shape_times_)[frames_]))
    write_shape(state_at((*shape_times_)[frames_]), output);
}

/// Times that differ by less are equal.
double Simulation::same_time() const {
  constexpr double kOfAStep = 1e-6;
  return kOfAStep * (now_.kt - before_.kt);
}

bool Simulation::is_reached(double kt) const { return kt <= now_.kt + same_time(); }

/// Whether the last step passed this time.
bool Simulation::passes(double kt) const { return is_reached(kt) && kt > before_.kt + same_time(); }

MembraneState Simulation::state_at(double kt) const {
  if (kt < now_.kt - same_time()) return between(before_, now_, kt);
  MembraneState state = now_;
  state.kt = kt;
  return state;
}

void Simulation::record(const MembraneState& state, RunOutput& output) {
  history_.push_back(measure_all({.parameters = case_,
                                  .mesh = sphere_.mesh,
                                  .reference = reference_,
                                  .positions = state.positions,
                                  .velocities = state.velocities,
                                  .forces = state.forces,
                                  .motion = tracker_.look(state.kt, state.positions),
                                  .iterations = std::exchange(iterations_since_record_, 0),
                                  .flow_error = last_flow_error_}));
  output.record(history_.back());
}

void Simulation::sample_motion() {
  if (!samples_.empty() && !is_reached(samples_.back().kt + kSampleInterval)) return;
  samples_.push_back(tracker_.observe(now_.kt, now_.positions));
  if (surface_.is_due(now_.kt)) surface_.add(now_.kt, surface_quality(sphere_.mesh, now_.positions));
}

Verdict Simulation::verdict() const { return limited_by_surface(classify(samples_), surface_); }

/// Whether the run has reached its end, may end early because its label is certain, or, after until.kt, has a
/// label at last. The label is tested only after each growth of kt by 1 %, because the time of a
/// classification is proportional to the length of the run.
std::optional<Outcome> Simulation::finished(RunOutput& output) {
  const Until& until = case_.until;
  if (is_reached(until.last())) return ended(Stop::reached_end, until.last(), output);
  if (!until.classified) return std::nullopt;
  const auto hundredths = [](double kt) { return std::floor(std::log(kt) / 0.01); };
  const bool at_kt = passes(until.kt);
  if (!at_kt && hundredths(now_.kt) == hundredths(before_.kt)) return std::nullopt;
  const Verdict label = verdict();
  if (at_kt && label.motion != Motion::undecided) return ended(Stop::reached_end, until.kt, output);
  if (label.steady) return ended(Stop::steady, now_.kt, output);
  if (label.certain || (now_.kt > until.kt && label.motion != Motion::undecided))
    return ended(Stop::classified, now_.kt, output);
  return std::nullopt;
}

/// Writes the state from which a run with a later end can go on. Then adds a record and a shape of the end,
/// if their times do not include it: they are not part of a longer run.
Outcome Simulation::ended(Stop stop, double kt, RunOutput& output) {
  output.last_state(state());
  if (!has_record_at(kt)) record(state_at(kt), output);
  if (shape_times_ && !has_shape_at(kt)) write_shape(state_at(kt), output);
  return {stop};
}

}  // namespace capstan
