#include "runner/worker/run_case.hpp"

#include <iostream>

#include "runner/worker/climb.hpp"
#include "runner/worker/rung_run.hpp"
#include "solver/case/ladder.hpp"
#include "solver/output/accuracy.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

std::string why_no_companion(const Case& c) {
  if (!has_ladder(c)) return "this flow model has no ladder of resolutions";
  if (!c.companion) return "the case asks for no companion";
  return "there is no coarser rung on the ladder";
}

}  // namespace

RunEnding run_case(const ParsedCase& parsed, const RunDirectory& directory, double end_seconds) {
  const Case& c = *parsed.value;
  if (c.fidelity.error > 0) return climb(parsed, directory, end_seconds);
  const std::optional<Case> coarse = companion_of(c);
  std::optional<FinishedRun> companion;
  if (coarse) {
    std::cerr << "companion with " << coarse->fidelity.nodes << " nodes\n";
    companion = compute_rung(*coarse, directory, end_seconds);
    if (!companion) return RunEnding::interrupted;
  }
  auto run = compute_run(c, parsed.choices, directory, end_seconds);
  if (!run) return RunEnding::interrupted;
  if (companion) add_seconds(run->result, companion->result);
  run->result.update(companion ? accuracy(*run, *companion) : unknown_accuracy(why_no_companion(c)));
  return write_result(directory, *run);
}

}  // namespace capstan
