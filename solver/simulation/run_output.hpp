#pragma once
// Interface for the output of a simulation: records, shapes and checkpoints. It also decides when the
// simulation writes a checkpoint or is interrupted.
#include "solver/mesh/triangle_mesh.hpp"
#include "solver/observe/observables.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

class RunOutput {
 public:
  virtual ~RunOutput() = default;
  /// The observables at a multiple of outputs.history_every, or at the end of the run.
  virtual void record(const Record& record) = 0;
  /// The membrane at a multiple of outputs.shapes_every, at the end of the run, or where it broke down.
  /// \param frame  counts from 0   \param positions, velocities, forces  3 x #V
  virtual void shape(double kt, int frame, const Points& positions, const Points& velocities,
                     const Points& forces) = 0;
  /// The state from which the run can be continued. Its views point into the simulation.
  virtual void checkpoint(StateArchive state) = 0;
  /// The last state of a run that has ended. A longer run goes on from it.
  virtual void last_state(StateArchive state) = 0;
  /// Called after each step.
  /// \param steps  since the start of the run
  virtual bool is_checkpoint_due(long steps) = 0;
  /// Whether the run should stop here with a checkpoint. Called after each step.
  virtual bool interrupted() const = 0;
};

}  // namespace capstan
