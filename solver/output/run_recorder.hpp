#pragma once
// The files of a run directory (schema/run_directory.md), as the process that computes the case writes them.
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/output/shape_writer.hpp"
#include "solver/output/share_of_time.hpp"
#include "solver/run_directory/run_directory.hpp"
#include "solver/simulation/run_output.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

/// Seconds since any fixed time; never decreasing.
using SecondsClock = std::function<double()>;
double steady_seconds();

class RunRecorder : public RunOutput {
 public:
  /// Creates the directory if it is not there.
  /// \param choices      the settings that were chosen for the case
  /// \param interrupted  whether the run should stop; called after every step
  RunRecorder(std::filesystem::path directory, const Case& c, Choices choices,
              std::function<bool()> interrupted, SecondsClock clock = steady_seconds);

  /// Restores the newest valid checkpoint, if there is one: of this run, or of a shorter one with equal steps
  /// that this run passes. Starts
  /// anew if a shape before the checkpoint is damaged. Calls `log` with one sentence for the checkpoint
  /// that is used, and one for each that cannot be used.
  void resume(Simulation& simulation, const std::function<void(const std::string&)>& log);

  void record(const Record& record) override;
  void shape(double kt, int frame, const Points& positions, const Points& velocities,
             const Points& forces) override;
  void checkpoint(StateArchive state) override;
  void last_state(StateArchive state) override;

  /// After each outputs.checkpoint_every steps, if that is not 0; and when the time since the last checkpoint
  /// is at least a tenth of the run's time so far (but 0.2 s to 30 s) and at least fifty times the time that
  /// writing the last checkpoint took.
  bool is_checkpoint_due(long steps) override;
  bool interrupted() const override { return interrupted_(); }

  /// Completes the index of the shapes. Returns the content of result.json.
  nlohmann::ordered_json finish(const Simulation& simulation, const Outcome& outcome);

 private:
  std::string obstacle_to(const StateArchive& checkpoint) const;
  void start_history(const History& history);
  StateArchive completed(StateArchive state) const;
  double seconds_here() const { return clock_() - started_; }
  double seconds() const { return seconds_before_ + seconds_here(); }

  RunDirectory directory_;
  Case case_;
  Choices choices_;
  std::function<bool()> interrupted_;
  std::ofstream history_;
  Faces faces_;
  Points reference_;  ///< the shape without tension
  std::optional<ShapeWriter> shapes_;
  SecondsClock clock_;
  double started_;
  double seconds_before_ = 0;  ///< of the earlier processes of this run
  ShareOfTime checkpoints_, indices_;
  double asked_ = 0;  ///< seconds, at the last call of is_checkpoint_due(): the cost of a checkpoint includes
                      ///< collecting the state
};

}  // namespace capstan
