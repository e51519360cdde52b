#include "solver/simulation/run_recorder.hpp"

#include <stdexcept>

#include "solver/case/content_id.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/result.hpp"
#include "solver/state/durable_file.hpp"

namespace capstan {

RunRecorder::RunRecorder(std::filesystem::path directory, const Case& c, Choices choices,
                         std::function<bool()> interrupted)
    : directory_(std::move(directory)),
      case_(c),
      choices_(std::move(choices)),
      interrupted_(std::move(interrupted)) {
  std::filesystem::create_directories(directory_);
}

void RunRecorder::resume(Simulation& simulation, const std::function<void(const std::string&)>& log) {
  if (const auto checkpoint = read_newest_checkpoint(directory_, case_id(case_), log)) {
    simulation.load(*checkpoint);
    seconds_before_ = checkpoint->number("seconds");
    log("resumed at step " + std::to_string(simulation.statistics().steps));
  }
  if (case_.outputs.shapes_every > 0) shapes_.emplace(directory_, simulation.faces());
  start_history(simulation.history());
}

/// What the checkpoint knows of the history replaces what a killed process left behind.
void RunRecorder::start_history(const History& history) {
  std::string lines;
  for (const Record& past : history) lines += to_json_line(past) + '\n';
  const std::filesystem::path path = directory_ / "history.jsonl";
  write_durably(path, lines);
  history_.open(path, std::ios::app);
}

void RunRecorder::record(const Record& now) {
  history_ << to_json_line(now) << std::endl;
  if (!history_) throw std::runtime_error("cannot write " + (directory_ / "history.jsonl").string());
}

void RunRecorder::shape(double kt, int frame, const Points& positions, const Points& velocities,
                        const Points& forces) {
  if (shapes_) shapes_->write(kt, frame, positions, velocities, forces);
}

void RunRecorder::checkpoint(StateArchive state) {
  state.put("seconds", seconds());
  write_checkpoint(directory_, state, case_id(case_));
}

double RunRecorder::seconds() const {
  return seconds_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

void RunRecorder::finish(const Simulation& simulation, const Outcome& outcome) {
  write_durably(directory_ / "result.json",
                result_json(case_, choices_, simulation, outcome, seconds()).dump(2) + "\n");
}

}  // namespace capstan
