#pragma once
// Keeps the output of a simulation in memory.
#include <map>
#include <utility>
#include <vector>

#include "solver/simulation/run_output.hpp"

namespace capstan::testing {

class MemoryOutput : public RunOutput {
 public:
  void record(const Record& now) override { records.push_back(now); }
  void shape(double kt, int frame, const Points& positions, const Points& velocities,
             const Points& forces) override {
    shapes.push_back({kt, frame, positions, velocities, forces});
  }
  void checkpoint(StateArchive state) override { checkpoints.push_back(copy_of(state)); }
  void last_state(StateArchive state) override { last = copy_of(state); }
  bool is_checkpoint_due(long steps) override {
    return checkpoint_every > 0 && steps % checkpoint_every == 0;
  }
  bool interrupted() const override { return interruption_wanted; }

  struct Shape {
    double kt;
    int frame;
    Points positions, velocities, forces;
    bool operator==(const Shape&) const = default;
  };

  std::vector<double> shape_times() const {
    std::vector<double> times;
    for (const Shape& shape : shapes) times.push_back(shape.kt);
    return times;
  }

  /// The archive itself only refers to arrays of the simulation, which change.
  static StateArchive copy_of(const StateArchive& state) {
    StateArchive copy;
    for (const std::string& name : state.names()) {
      const auto data = state.get(name);
      copy.put(name, std::vector<double>(data.begin(), data.end()));
    }
    return copy;
  }

  History records;
  std::vector<Shape> shapes;
  std::vector<StateArchive> checkpoints;
  StateArchive last;  ///< state
  int checkpoint_every = 0;
  bool interruption_wanted = false;
};

}  // namespace capstan::testing
