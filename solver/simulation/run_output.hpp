#pragma once
// Where a simulation puts what it finds, and from where it is told to stop.
#include "solver/mesh/triangle_mesh.hpp"
#include "solver/observe/history.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

class RunOutput {
 public:
  virtual ~RunOutput() = default;
  virtual void record(const Record& record) = 0;
  /// The membrane at a time asked for, or where a run broke down; frames count from 0.
  virtual void shape(double kt, int frame, const Points& positions, const Points& velocities,
                     const Points& forces) = 0;
  virtual void checkpoint(StateArchive state) = 0;
  /// Asked after each step. \param steps  since the start of the run
  virtual bool is_checkpoint_due(long steps) = 0;
  virtual bool interrupted() const = 0;
};

}  // namespace capstan
