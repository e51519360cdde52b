#include "solver/output/run_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "solver/case/equal_steps.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/output/result.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

void put_end(StateArchive& state, const Until& until) {
  state.put("until", {until.kt, double(until.classified), until.at_most});
}

Until end_in(const StateArchive& state) {
  const auto saved = state.get("until");
  return {.kt = saved[0], .classified = saved[1] != 0, .at_most = saved[2]};
}

/// Whether a run with this end goes through the state of the checkpoint.
bool passes(const Until& until, const StateArchive& state) {
  const Until earlier = end_in(state);
  return until == earlier || passes_end_of(earlier, std::min(state.number("kt"), earlier.last()), until);
}

}  // namespace

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

RunRecorder::RunRecorder(std::filesystem::path directory, const Case& c, Choices choices,
                         std::function<bool()> interrupted, SecondsClock clock)
    : directory_(std::move(directory)),
      case_(c),
      choices_(std::move(choices)),
      interrupted_(std::move(interrupted)),
      clock_(std::move(clock)),
      started_(clock_()) {
  std::filesystem::create_directories(directory_.path());
}

/// Why the run cannot go on from the checkpoint; empty if it can.
std::string RunRecorder::obstacle_to(const StateArchive& checkpoint) const {
  if (!passes(case_.until, checkpoint))
    return "the checkpoint is of a run with another end, which this run does not pass";
  const auto damaged = first_damaged_frame(directory_, int(checkpoint.number("frames")));
  return damaged ? damaged->string() + " cannot be read" : "";
}

void RunRecorder::resume(Simulation& simulation, const std::function<void(const std::string&)>& log) {
  const auto checkpoint = read_newest_checkpoint(directory_.path(), steps_id(case_), log);
  const std::string obstacle = checkpoint ? obstacle_to(*checkpoint) : "";
  if (!obstacle.empty()) log(obstacle + ": the run starts anew");
  if (checkpoint && obstacle.empty()) {
    simulation.load(*checkpoint);
    seconds_before_ = checkpoint->number("seconds");
    log("resumed at step " + std::to_string(simulation.statistics().steps) +
        ", kt = " + rounded(simulation.kt(), 4));
  }
  faces_ = simulation.faces();
  reference_ = simulation.reference();
  start_history(simulation.history());
}

/// Replaces the history file by the history of the checkpoint: the file may contain later records of a killed
/// process.
void RunRecorder::start_history(const History& history) {
  std::string lines;
  for (const Record& past : history) lines += to_json_line(past) + '\n';
  const std::filesystem::path path = directory_.history_file();
  write_durably(path, lines);
  history_.open(path, std::ios::app);
}

void RunRecorder::record(const Record& now) {
  history_ << to_json_line(now) << std::endl;
  if (!history_) throw std::runtime_error("cannot write " + directory_.history_file().string());
}

void RunRecorder::shape(double kt, int frame, const Points& positions, const Points& velocities,
                        const Points& forces) {
  if (!shapes_)
    shapes_.emplace(directory_.path(), faces_,
                    InPlaneElasticity(faces_, reference_, *case_.law, case_.law_constants, 1 / case_.Ca));
  shapes_->write(kt, frame, positions, velocities, forces);
  const double now = seconds_here();
  if (!indices_.is_due(now, 0)) return;
  shapes_->write_index();
  indices_.done(now, seconds_here());
}

StateArchive RunRecorder::completed(StateArchive state) const {
  state.put("seconds", seconds());
  put_end(state, case_.until);
  return state;
}

/// Does not wait for the disk: if the file is lost, a longer run starts anew.
void RunRecorder::last_state(StateArchive state) {
  write_checkpoint(directory_.path(), completed(std::move(state)), steps_id(case_), Durable::no);
}

void RunRecorder::checkpoint(StateArchive state) {
  write_checkpoint(directory_.path(), completed(std::move(state)), steps_id(case_), Durable::yes);
  checkpoints_.done(asked_, seconds_here());
}

bool RunRecorder::is_checkpoint_due(long steps) {
  constexpr double kMin = 0.2, kMax = 30;  // s
  const int every = case_.outputs.checkpoint_every;
  asked_ = seconds_here();
  if (every > 0 && steps % every == 0) return true;
  return checkpoints_.is_due(asked_, std::clamp(seconds() / 10, kMin, kMax));
}

nlohmann::ordered_json RunRecorder::finish(const Simulation& simulation, const Outcome& outcome) {
  if (shapes_) shapes_->write_index();
  return result_json(case_, choices_, simulation, outcome, seconds());
}

}  // namespace capstan
