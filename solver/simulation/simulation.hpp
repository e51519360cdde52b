#pragma once
// One capsule in shear flow from its initial shape to the end of the run.
#include <memory>
#include <optional>
#include <string>

#include "solver/case/case.hpp"
#include "solver/case/output_times.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/membrane/membrane.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/observe/classify.hpp"
#include "solver/observe/motion_sample.hpp"
#include "solver/observe/motion_tracker.hpp"
#include "solver/observe/observables.hpp"
#include "solver/observe/surface_watch.hpp"
#include "solver/run_directory/stop.hpp"
#include "solver/simulation/membrane_state.hpp"
#include "solver/simulation/run_output.hpp"
#include "solver/simulation/time_step.hpp"

namespace capstan {

/// Why a simulation stopped. A numerical failure is an outcome, not an exception.
struct Outcome {
  Stop stop;
  std::string message = {};  ///< what went wrong and when; empty if nothing did
};

/// Cost of a run, and its numerical errors.
struct RunStatistics {
  long steps = 0;  ///< of the membrane
  long flow_iterations = 0;
  double worst_flow_error = 0;  ///< largest estimated relative error of the flow at the ends of the steps
  double volume_drift = 0;      ///< largest |V/V(0) - 1| at the ends of the steps
  double area_drift = 0;        ///< largest |A/A(0) - 1| at the ends of the steps
};

class Simulation {
 public:
  explicit Simulation(const Case& c);

  /// Runs the paper's algorithm until the case ends or `output` requests an interruption. The time steps do
  /// not depend on the end of the run or the times of records and shapes: a state between two steps is
  /// interpolated. A run that ends writes a checkpoint, from which a case with a later end can go on. A run
  /// that breaks down writes its last valid state and the invalid one.
  Outcome run(RunOutput& output);

  /// Restores the state of a checkpoint that run() wrote, for this case or for one with equal steps that can
  /// be prolonged to it (equal_steps.hpp). The continued run equals the uninterrupted one to the last bit.
  void load(const StateArchive& archive);

  const Faces& faces() const { return sphere_.mesh.faces; }
  /// 3 x #V, the stress-free shape, which is the initial shape
  const Points& reference() const { return reference_; }
  double kt() const { return now_.kt; }
  const History& history() const { return history_; }
  const MotionSamples& samples() const { return samples_; }
  /// The motion so far. Undecided if the mesh did not resolve the surface.
  Verdict verdict() const;
  const SurfaceWatch& surface() const { return surface_; }
  const RunStatistics& statistics() const { return statistics_; }

 private:
  // Each of these returns an outcome if the run stops, and nothing if it continues.
  std::optional<Outcome> step();
  std::optional<Outcome> solve_flow_now();
  FlowReport solve_flow(double at, const Points& positions, Points& velocities);
  std::optional<Outcome> failure(const FlowReport& flow) const;
  std::optional<Outcome> refusal(const StepReport& step);
  Outcome stopped(Stop stop, const std::string& what) const;
  std::optional<Outcome> finished(RunOutput& output);
  Outcome ended(Stop stop, double kt, RunOutput& output);
  bool passes(double kt) const;
  void count(const FlowReport& flow);
  void count_drift();
  std::optional<Outcome> observe(RunOutput& output);
  void write_output_to(double end, RunOutput& output);
  double same_time() const;
  bool is_reached(double kt) const;
  MembraneState state_at(double kt) const;
  void record(const MembraneState& state, RunOutput& output);
  void write_shape(const MembraneState& state, RunOutput& output);
  bool has_record_at(double kt) const;
  bool has_shape_at(double kt) const;
  void write_breakdown(RunOutput& output);
  void sample_motion();
  StateArchive state() const;

  Case case_;
  Icosphere sphere_;
  Points reference_;      ///< 3 x #V, the stress-free shape, which is the initial shape
  MembraneState now_;     ///< at the end of the last step
  MembraneState before_;  ///< at the start of the last step
  MembraneState solved_;  ///< of the last flow solution; all positions are 0 before the first
  Orbits orbits_;
  Membrane membrane_;
  std::unique_ptr<FlowModel> flow_;
  std::unique_ptr<TimeStepper> stepper_;
  OutputTimes record_times_;
  std::optional<OutputTimes> shape_times_;
  MotionTracker tracker_;
  MotionSamples samples_;
  SurfaceWatch surface_;
  History history_;
  int frames_ = 0;  ///< shapes written so far
  double initial_volume_, initial_area_;
  int iterations_since_record_ = 0;  ///< of the flow
  double last_flow_error_ = 0;
  int refusals_ = 0;            ///< rejected steps on a surface that the mesh does not resolve
  double recent_refusals_ = 0;  ///< rejected steps on any surface, each weighted with exp(-kt since then)
  RunStatistics statistics_;
};

}  // namespace capstan
