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

/// Seconds that never go back.
using SecondsClock = std::function<double()>;
double steady_seconds();

class RunRecorder : public RunOutput {
 public:
  /// Creates the directory if it is not there.
  /// \param choices      made for the case   \param interrupted  asked after every step
  RunRecorder(std::filesystem::path directory, const Case& c, Choices choices,
              std::function<bool()> interrupted, SecondsClock clock = steady_seconds);

  /// Puts the simulation where the newest valid checkpoint left it, or leaves it at its start.
  /// What is said about it goes to `log`.
  void resume(Simulation& simulation, const std::function<void(const std::string&)>& log);

  void record(const Record& record) override;
  void shape(double kt, int frame, const Points& positions, const Points& velocities,
             const Points& forces) override;
  void checkpoint(StateArchive state) override;

  /// After each outputs.checkpoint_every steps, if there is such a wish. And by time: when the time since the
  /// last one is a tenth of the run's (30 s at the most), and fifty times what the last one took.
  bool is_checkpoint_due(long steps) override;
  bool interrupted() const override { return interrupted_(); }

  /// Completes the index of the shapes, and writes result.json, the mark of a finished run, if it is
  /// finished.
  void finish(const Simulation& simulation, const Outcome& outcome);

 private:
  void start_history(const History& history);
  double seconds_here() const { return clock_() - started_; }
  double seconds() const { return seconds_before_ + seconds_here(); }

  RunDirectory directory_;
  Case case_;
  Choices choices_;
  std::function<bool()> interrupted_;
  std::ofstream history_;
  Faces faces_;
  std::optional<ShapeWriter> shapes_;
  SecondsClock clock_;
  double started_;
  double seconds_before_ = 0;  ///< spent by the processes that this one resumes
  ShareOfTime checkpoints_, indices_;
  double asked_ = 0;  ///< when it was asked whether a checkpoint is due: to collect the state takes time, too
};

}  // namespace capstan
