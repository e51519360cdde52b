#pragma once
// One capsule in shear flow from its initial shape to the end of the run.
#include <memory>
#include <optional>
#include <string>

#include "solver/case/case.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/membrane/membrane.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/observe/classify.hpp"
#include "solver/observe/history.hpp"
#include "solver/observe/motion_sample.hpp"
#include "solver/observe/motion_tracker.hpp"
#include "solver/observe/surface_watch.hpp"
#include "solver/simulation/membrane_state.hpp"
#include "solver/simulation/output_times.hpp"
#include "solver/simulation/run_output.hpp"
#include "solver/simulation/time_step.hpp"

namespace capstan {

enum class Stop {
  reached_end,
  classified,  ///< early: more time would not change the label
  steady,      ///< early: the shape does not change any more
  diverged,
  not_converged,
  interrupted,
};
std::string_view to_string(Stop stop);

/// Whether the run came to a motion.
constexpr bool has_answer(Stop stop) {
  return stop == Stop::reached_end || stop == Stop::classified || stop == Stop::steady;
}

/// How a run ended. A numerical failure is an outcome, not an exception.
struct Outcome {
  Stop stop;
  std::string message = {};  ///< what went wrong, where and when; empty when nothing did
};

/// What the run cost and how far its numbers may be trusted.
struct RunStatistics {
  long steps = 0;
  long flow_iterations = 0;
  double worst_flow_error = 0;  ///< largest estimated relative error of a flow solution
  double volume_drift = 0;      ///< largest |V/V(0) - 1| of the samples
  double area_drift = 0;        ///< largest |A/A(0) - 1| of the samples
};

class Simulation {
 public:
  explicit Simulation(const Case& c);

  /// The paper's algorithm, to the end or until `output` asks for an interruption. Its steps do not depend on
  /// what is asked for: records and shapes between two steps are interpolated. A run that breaks down shows
  /// its last sound state and the one that went wrong.
  Outcome run(RunOutput& output);

  /// Continues from a checkpoint that run() wrote; the outcome is that of the uninterrupted run to the last
  /// bit.
  void load(const StateArchive& archive);

  const Faces& faces() const { return sphere_.mesh.faces; }
  double kt() const { return now_.kt; }
  const History& history() const { return history_; }
  const MotionSamples& samples() const { return samples_; }
  /// Doubtful where the surface was folded, undecided where the mesh could not represent it.
  Verdict verdict() const;
  const SurfaceWatch& surface() const { return surface_; }
  const RunStatistics& statistics() const { return statistics_; }

 private:
  std::optional<Outcome> step();
  std::optional<Outcome> find_flow();
  FlowReport solve_flow(double at, const Points& positions, Points& velocities);
  std::optional<Outcome> failure(const FlowReport& flow) const;
  std::optional<Outcome> refusal(const StepReport& step);
  Outcome stopped(Stop stop, const std::string& what) const;
  std::optional<Outcome> finished(RunOutput& output);
  void note(const FlowReport& flow);
  void put_out(RunOutput& output);
  bool has_come(double time) const;
  MembraneState state_at(double time) const;
  void record(const MembraneState& state, RunOutput& output);
  void show_breakdown(RunOutput& output);
  bool is_shown(double time) const;
  void show(const MembraneState& state, RunOutput& output);
  void observe();
  void save_checkpoint(RunOutput& output) const;

  Case case_;
  Icosphere sphere_;
  MembraneState now_;     ///< where the last step ended
  MembraneState before_;  ///< where it began
  MembraneState solved_;  ///< of the last flow; positions all zero before the first
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
  int frames_ = 0;
  double initial_volume_, initial_area_;
  int iterations_since_record_ = 0;
  double last_flow_error_ = 0;
  int refusals_ = 0;            ///< of steps, on a surface that is lost
  double recent_refusals_ = 0;  ///< of steps, on any surface; each fades with exp(-kt)
  RunStatistics statistics_;
};

/// The symmetry that a case's capsule keeps to the last bit, because its flow model makes use of it.
Orbits symmetry_of(const Case& c, const Points& initial);

/// The flow model a case asks for. \param initial 3 x #V, the positions at the start   \param orbits of them
std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                     const Orbits& orbits);

/// \param imposed_kdt  the flow model's own time step, if it has one
std::unique_ptr<TimeStepper> make_stepper(const Case& c, std::optional<double> imposed_kdt);

/// Parts of the physics that this case does without, one sentence each.
std::vector<std::string> left_out(const Case& c);

}  // namespace capstan
