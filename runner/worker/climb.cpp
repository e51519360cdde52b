#include "runner/worker/climb.hpp"

#include <cmath>
#include <iostream>

#include "runner/worker/rung_run.hpp"
#include "solver/case/ladder.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/mesh/surface_quality.hpp"
#include "solver/output/accuracy.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// A run with the one at the rung below.
struct Pair {
  FinishedRun run, companion;
};

struct Climb {
  std::optional<Pair> best;        ///< the finest that has an answer; the finest if none has
  std::optional<double> estimate;  ///< of the last rung
  double seconds = 0;              ///< of all runs
  bool is_met = false, is_interrupted = false;
  std::string why_no_finer;  ///< why finer rungs would not help; empty if they may
};

std::string resolution_of(const Case& rung) {
  return std::to_string(rung.fidelity.nodes) + " nodes" +
         (rung.has_grid() ? ", dx = " + shown(rung.fidelity.dx) : "");
}

void print_rung(const Case& rung) { std::cerr << resolution_of(rung) << "\n"; }

void print_error(std::optional<double> error) {
  std::cerr << "estimated error: " << (error ? rounded(*error, 2) : "unknown") << "\n";
}

/// Computes the rung, unless it was computed before.
std::optional<FinishedRun> run_of(const Case& rung, const RunDirectory& directory, double end_seconds,
                                  Climb& climb) {
  print_rung(rung);
  auto run = compute_rung(rung, directory, end_seconds);
  climb.is_interrupted = !run;
  if (run) climb.seconds += run->result["cost"]["seconds"].get<double>();
  return run;
}

/// Why finer rungs are not expected to come nearer; empty if they are. On fine meshes errors fall from rung
/// to rung, unless the membrane wrinkles, or the estimate is the smallest that is ever given.
std::string why_no_finer(const FinishedRun& run, std::optional<double> estimate,
                         std::optional<double> before) {
  const int fine = run.parameters.has_grid() ? 2562 : 1442;
  if (run.parameters.fidelity.nodes < fine) return "";
  if (!run.is_answered())
    return "and the run with " + resolution_of(run.parameters) +
           " failed: " + run.result["message"].get<std::string>();
  if (!estimate || !before || *estimate < *before) return "";
  const bool wrinkles = run.result["trust"]["surface"]["largest_dihedral"] > kWrinkledEdge;
  return std::string("and it does not fall any further with the resolution") +
         (wrinkles ? ": the membrane wrinkles, where a bending stiffness E_b helps" : "");
}

void judge(const FinishedRun& run, const FinishedRun& below, double error, Climb& climb) {
  const std::optional<double> before = climb.estimate;
  climb.estimate = estimate_of(run, below);
  print_error(climb.estimate);
  climb.is_met = climb.estimate && *climb.estimate <= error;
  climb.why_no_finer = why_no_finer(run, climb.estimate, before);
  if (run.is_answered() || !climb.best || !climb.best->run.is_answered()) climb.best = Pair{run, below};
}

Climb climb_to(double error, const Case& first, const RunDirectory& directory, double end_seconds) {
  Climb climb;
  auto below = run_of(rung_below(first).value(), directory, end_seconds, climb);
  std::optional<Case> rung = first;
  while (rung && below && !climb.is_met && climb.why_no_finer.empty()) {
    auto run = run_of(*rung, directory, end_seconds, climb);
    if (run) judge(*run, *below, error, climb);
    below = std::move(run);
    rung = rung_above(*rung);
  }
  return climb;
}

ordered_json accuracy_of(const Climb& climb, double asked) {
  ordered_json shown = accuracy(climb.best->run, climb.best->companion);
  shown["error"]["asked"] = asked;
  shown["error"]["met"] = climb.is_met;
  shown["error"]["nodes"] = climb.best->run.parameters.fidelity.nodes;
  if (climb.best->run.parameters.has_grid()) shown["error"]["dx"] = climb.best->run.parameters.fidelity.dx;
  return shown;
}

std::string not_met(const ordered_json& error, const Climb& climb) {
  const ordered_json& reached = error["Q"];
  return "the error asked for, " + rounded(error["asked"]) + ", was not met: " +
         (reached.is_number() ? "it is estimated as " + rounded(reached) : "it is unknown") + " with " +
         resolution_of(climb.best->run.parameters) + ", " +
         (climb.why_no_finer.empty()
              ? "and no finer rung has an answer; ask for a shorter until.kt or a larger error"
              : climb.why_no_finer);
}

/// The directory of the case shows the shapes of a rung. The rung keeps its own, with which a longer run goes
/// on.
void show_shapes(const RunDirectory& rung, const RunDirectory& of_case) {
  if (!fs::exists(rung.shapes_directory())) return;
  fs::remove_all(of_case.shapes_directory());
  link_files(rung.shapes_directory(), of_case.shapes_directory());
  fs::copy_file(rung.shape_index_file(), of_case.shape_index_file(), fs::copy_options::overwrite_existing);
}

void publish_files(const FinishedRun& run, const RunDirectory& directory) {
  const RunDirectory rung = directory.rung(run.parameters.fidelity.nodes);
  write_durably(directory.history_file(), read_file(rung.history_file()).value_or(""));
  show_shapes(rung, directory);
}

}  // namespace

RunEnding climb(const ParsedCase& parsed, const RunDirectory& directory, double end_seconds) {
  const Case& c = *parsed.value;
  const double asked = c.fidelity.error;
  Climb climb = climb_to(asked, first_of_climb(c), directory, end_seconds);
  if (climb.is_interrupted) return RunEnding::interrupted;
  FinishedRun& best = climb.best->run;
  const ordered_json accuracy = accuracy_of(climb, asked);
  publish_files(best, directory);
  best.result["case"] = to_json(c);
  best.result["choices"] = to_json(parsed.choices);
  best.result["cost"]["seconds"] = std::round(1000 * climb.seconds) / 1000;
  best.result.update(accuracy);
  if (!climb.is_met) best.result["trust"]["warnings"].push_back(not_met(accuracy["error"], climb));
  return write_result(directory, best);
}

}  // namespace capstan
