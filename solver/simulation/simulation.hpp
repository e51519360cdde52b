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
#include "solver/observe/motion_tracker.hpp"
#include "solver/simulation/run_output.hpp"
#include "solver/simulation/time_step.hpp"

namespace capstan {

enum class Stop { reached_end, classified, diverged, not_converged, interrupted };
std::string_view word(Stop stop);

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
  double volume_drift = 0;      ///< largest |V/V(0) - 1| recorded
  double area_drift = 0;        ///< largest |A/A(0) - 1| recorded
};

/// The steps of a run, and those after which something is recorded: the nearest to the wished intervals. A
/// stepper that chooses its own steps does so between two records, which count as one step here.
struct TimeGrid {
  TimeGrid(const Case& c, std::optional<double> imposed_kdt);
  double kdt;
  long steps, steps_a_record;
  long steps_a_shape = 0;  ///< 0: no shapes
};

class Simulation {
 public:
  explicit Simulation(const Case& c);

  /// The paper's algorithm, to the end or until `output` asks for an interruption.
  Outcome run(RunOutput& output);

  /// Continues from a checkpoint that run() wrote; the outcome is that of the uninterrupted run to the last
  /// bit.
  void load(const StateArchive& archive);

  const Faces& faces() const { return sphere_.mesh.faces; }
  const History& history() const { return history_; }
  const RunStatistics& statistics() const { return statistics_; }
  long steps_to_end() const { return time_.steps; }

 private:
  double kt(int steps_ahead = 0) const;
  FlowReport solve_flow(double at, const Points& positions, Points& velocities);
  std::optional<Outcome> failure(const FlowReport& flow) const;
  std::optional<Outcome> finished() const;
  void note(const FlowReport& flow);
  bool record_is_due() const;
  void record(RunOutput& output);
  void save_checkpoint(RunOutput& output) const;

  Case case_;
  Icosphere sphere_;
  Points positions_, forces_, velocities_;  ///< 3 x #V
  struct Solved {
    Points positions, velocities;
  } solved_;  ///< the last flow; positions all zero before the first
  Orbits orbits_;
  Membrane membrane_;
  std::unique_ptr<FlowModel> flow_;
  std::unique_ptr<TimeStepper> stepper_;
  TimeGrid time_;
  MotionTracker tracker_;
  History history_;
  double initial_volume_, initial_area_;
  int iterations_since_record_ = 0;
  double last_flow_error_ = 0;
  RunStatistics statistics_;
};

/// The symmetry that a case's capsule keeps to the last bit, because its flow model makes use of it.
Orbits symmetry_of(const Case& c, const Points& initial);

/// The flow model a case asks for. \param initial 3 x #V, the positions at the start   \param orbits of them
std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                     const Orbits& orbits);

std::unique_ptr<TimeStepper> make_stepper(const Case& c);

/// Parts of the physics that this case does without, one sentence each.
std::vector<std::string> left_out(const Case& c);

}  // namespace capstan
