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
  /// The membrane at a recorded time, if the case asks for shapes; frames count from 0.
  virtual void shape(double kt, int frame, const Points& positions, const Points& velocities,
                     const Points& forces) = 0;
  virtual void checkpoint(StateArchive state) = 0;
  virtual bool interrupted() const = 0;
};

}  // namespace capstan
