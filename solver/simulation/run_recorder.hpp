#pragma once
// The files of a run directory (schema/run_directory.md), as the process that computes the case writes them.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/simulation/run_output.hpp"
#include "solver/simulation/shape_writer.hpp"
#include "solver/simulation/simulation.hpp"

namespace capstan {

class RunRecorder : public RunOutput {
 public:
  /// Creates the directory if it is not there.
  /// \param choices      made for the case   \param interrupted  asked after every step
  RunRecorder(std::filesystem::path directory, const Case& c, Choices choices,
              std::function<bool()> interrupted);

  /// Puts the simulation where the newest valid checkpoint left it, or leaves it at its start.
  /// What is said about it goes to `log`.
  void resume(Simulation& simulation, const std::function<void(const std::string&)>& log);

  void record(const Record& record) override;
  void shape(double kt, int frame, const Points& positions, const Points& velocities,
             const Points& forces) override;
  void checkpoint(StateArchive state) override;
  bool interrupted() const override { return interrupted_(); }

  /// result.json: the mark of a finished run.
  void finish(const Simulation& simulation, const Outcome& outcome);

 private:
  void start_history(const History& history);
  double seconds() const;

  std::filesystem::path directory_;
  Case case_;
  Choices choices_;
  std::function<bool()> interrupted_;
  std::ofstream history_;
  std::optional<ShapeWriter> shapes_;
  double seconds_before_ = 0;  ///< spent by the processes that this one resumes
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace capstan
