#pragma once
// What a simulation puts out, kept in memory.
#include <map>
#include <utility>
#include <vector>

#include "solver/simulation/run_output.hpp"

namespace capstan::testing {

class MemoryOutput : public RunOutput {
 public:
  void record(const Record& now) override { records.push_back(now); }
  void shape(double kt, int, const Points&, const Points&, const Points&) override {
    shape_times.push_back(kt);
  }
  /// Copies: the archive's views show the simulation's own state, which goes on.
  void checkpoint(StateArchive state) override {
    StateArchive& copy = checkpoints.emplace_back();
    for (const std::string& name : state.names()) {
      const auto data = state.get(name);
      copy.put(name, std::vector<double>(data.begin(), data.end()));
    }
  }
  bool interrupted() const override { return interruption_wanted; }

  History records;
  std::vector<double> shape_times;
  std::vector<StateArchive> checkpoints;
  bool interruption_wanted = false;
};

}  // namespace capstan::testing
