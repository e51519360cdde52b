// The files of a run: while it runs, after it was killed, and after it broke down.
#include "solver/output/run_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/history_line.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::Le;
using ::testing::SizeIs;

struct Killed {};

/// A recorder whose process is killed at a time of the run.
class Mortal : public RunRecorder {
 public:
  Mortal(const std::filesystem::path& directory, const Case& c, std::function<bool()> interrupted,
         SecondsClock clock, double killed_at)
      : RunRecorder(directory, c, {}, std::move(interrupted), std::move(clock)),
        directory_(directory),
        killed_at_(killed_at) {}

  void record(const Record& now) override {
    RunRecorder::record(now);
    if (now["kt"] >= killed_at_) throw Killed();
  }

  void shape(double kt, int frame, const Points& positions, const Points& velocities,
             const Points& forces) override {
    RunRecorder::shape(kt, frame, positions, velocities, forces);
    index_sizes_.insert(std::filesystem::file_size(directory_ / "shapes.xdmf2"));
  }

  std::size_t indices_written() const { return index_sizes_.size(); }

 private:
  std::filesystem::path directory_;
  double killed_at_;
  std::set<std::uintmax_t> index_sizes_;
};

class RunFiles : public ::testing::Test {
 protected:
  /// Runs one process in which a step takes `step_seconds`. Returns the kt at which it started.
  double run(const Case& c, double killed_at = 1e9) {
    const auto after_a_step = [this] {
      seconds_ += step_seconds_;
      return false;
    };
    Mortal recorder(
        directory_.path(), c, after_a_step, [this] { return seconds_; }, killed_at);
    Simulation simulation(c);
    recorder.resume(simulation, [](const std::string&) {});
    const double began = simulation.kt();
    try {
      const Outcome outcome = simulation.run(recorder);
      const nlohmann::ordered_json result = recorder.finish(simulation, outcome);
      if (outcome.stop != Stop::interrupted) write_durably(directory_.path() / "result.json", result.dump());
    } catch (const Killed&) {
    }
    return began;
  }

  std::vector<double> times_in_index() const {
    const std::string text = file_bytes(directory_.path() / "shapes.xdmf2");
    const std::regex time("Time Value=\"([^\"]*)\"");
    std::vector<double> times;
    for (std::sregex_iterator match(text.begin(), text.end(), time); match != std::sregex_iterator(); ++match)
      times.push_back(std::stod((*match)[1]));
    return times;
  }

  History history() const {
    std::ifstream lines(directory_.path() / "history.jsonl");
    History all;
    for (std::string line; std::getline(lines, line);) all.push_back(parse_record(line).value());
    return all;
  }

  TemporaryDirectory directory_;
  double seconds_ = 1000, step_seconds_ = 1;
};

Case red_cell(double kt) {
  Case c = testing::parsed_case(
      R"({"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 2, "Ca": 0.25,
    "fluid": "stokes", "fidelity": {"nodes": 162}, "outputs": {"shapes_every": 0.5}})");
  c.until.kt = kt;
  return c;
}

TEST_F(RunFiles, OfAStokesRunKilledAtTwoThirdsLetItResumeNearThere) {
  const Case c = red_cell(30);
  EXPECT_EQ(run(c, 20), 0);
  EXPECT_GT(run(c), 17.5);
  testing::MemoryOutput undisturbed;
  Simulation(c).run(undisturbed);
  EXPECT_EQ(history(), undisturbed.records);
  EXPECT_EQ(times_in_index(), undisturbed.shape_times());
}

TEST_F(RunFiles, CheckpointsAreATenthOfTheRunApartAndAtMostHalfAMinute) {
  Case c = red_cell(1);
  RunRecorder recorder(
      directory_.path(), c, {}, [] { return false; }, [this] { return seconds_; });
  std::vector<double> written;
  for (double run = 0; run < 700; run += 0.1) {
    seconds_ = 1000 + run;
    if (!recorder.is_checkpoint_due(1)) continue;
    recorder.checkpoint({});
    written.push_back(run);
  }
  for (std::size_t n = 1; n < written.size(); ++n)
    EXPECT_NEAR(written[n] - written[n - 1], std::clamp(0.1 * written[n], 0.2, 30.0), 0.15) << written[n];
}

TEST_F(RunFiles, CheckpointsAfterANumberOfStepsAreWrittenToo) {
  Case c = red_cell(1);
  c.outputs.checkpoint_every = 7;
  RunRecorder recorder(
      directory_.path(), c, {}, [] { return false; }, [] { return 0.0; });
  EXPECT_TRUE(recorder.is_checkpoint_due(14));
  EXPECT_FALSE(recorder.is_checkpoint_due(15));
}

TEST_F(RunFiles, IndexFollowsTheShapesOfASlowRun) {
  run(red_cell(2), 1.7);
  EXPECT_THAT(times_in_index(), ElementsAre(0, 0.5, 1, 1.5));
}

TEST_F(RunFiles, IndexOfManyShapesIsWrittenSeldomAndAtTheEnd) {
  Case c = red_cell(2);
  c.outputs.shapes_every = 0.01;
  const auto clock = [this] { return seconds_ += 0.01; };  // writing an index takes as long as a step
  Mortal recorder(
      directory_.path(), c, [] { return false; }, clock, 1e9);
  Simulation simulation(c);
  recorder.resume(simulation, [](const std::string&) {});
  const Outcome outcome = simulation.run(recorder);
  recorder.finish(simulation, outcome);
  EXPECT_THAT(recorder.indices_written(), AllOf(Ge(2u), Le(20u)));
  EXPECT_THAT(times_in_index(), SizeIs(201));
}

TEST_F(RunFiles, OfARunThatBreaksDownHoldItsLastValidStateAndTheInvalidOne) {
  Case c = testing::parsed_case(
      R"({"shape": "biconcave", "law": "skalak", "C": 5, "Ca": 0.05, "fluid": "quasisteady",
    "until": {"kt": 20}, "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.2}})");
  run(c);
  const auto times = times_in_index();
  ASSERT_GE(times.size(), 3u);
  const auto result = nlohmann::json::parse(file_bytes(directory_.path() / "result.json"));
  EXPECT_EQ(result["stop"], "diverged");
  EXPECT_DOUBLE_EQ(times.back() - times[times.size() - 2], 0.2);
  EXPECT_EQ(history().back()["kt"], times[times.size() - 2]);
  EXPECT_EQ(result["final"]["kt"], history().back()["kt"]);
}

}  // namespace
}  // namespace capstan
