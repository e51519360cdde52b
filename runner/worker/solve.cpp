#include "runner/worker/solve.hpp"

#include <omp.h>
#include <cstdlib>
#include <iostream>

#include "runner/worker/case_file.hpp"
#include "runner/worker/interruption.hpp"
#include "runner/worker/run_case.hpp"
#include "solver/case/case_warnings.hpp"
#include "solver/case/content_id.hpp"
#include "solver/case/equal_steps.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/output/run_recorder.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/directory_lock.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/run_ending.hpp"

namespace capstan {
namespace {

/// One core, unless OMP_NUM_THREADS says more. The daemon runs one case on each core; more threads than cores
/// would wait for each other.
void use_one_core_by_default() {
  if (!std::getenv("OMP_NUM_THREADS")) omp_set_num_threads(1);
}

/// Writes the case file if the directory has none. Returns whether the directory belongs to the case: it
/// belongs to the first case that ran there.
bool claim_directory(const RunDirectory& directory, const Case& c) {
  if (!std::filesystem::exists(directory.case_file()))
    write_durably(directory.case_file(), to_json(c).dump(2) + "\n");
  const ParsedCase owner = read_case(directory.case_file());
  return owner.value && case_id(*owner.value) == case_id(c);
}

void print_choices_and_warnings(const ParsedCase& parsed) {
  for (const Choice& choice : parsed.choices) std::cerr << in_words(choice) << "\n";
  for (const std::string& warning : case_warnings(*parsed.value)) std::cerr << "warning: " << warning << "\n";
}

/// Why the case cannot go on from a shorter run; "" if it can.
std::string obstacle_to(const RunDirectory& shorter, const Case& c) {
  const std::string name = shorter.path().string();
  if (!shorter.result()) return name + " holds no finished run";
  const ParsedCase earlier = read_case(shorter.case_file());
  if (!earlier.value || steps_id(*earlier.value) != steps_id(c))
    return name + " holds another case: only until, companion and outputs.checkpoint_every may differ";
  const double reached = shorter.result()->at("final").at("kt");
  if (!passes_end_of(earlier.value->until, reached, c.until))
    return "the run in " + name + " ended at kt = " + shown(reached) +
           ", which this case does not pass: raise until.kt, or ask for the same until.classified";
  return "";
}

int lock_and_run(const std::filesystem::path& case_file, const std::filesystem::path& out, double end_seconds,
                 const std::filesystem::path& shorter) {
  const ParsedCase parsed = read_case(case_file);
  print_case_issues(case_file, parsed.issues);
  if (!parsed.value) return kExitInvalidInput;
  std::filesystem::create_directories(out);
  const RunDirectory directory(out);
  DirectoryLock lock = DirectoryLock::inherited_or_new(directory);
  if (!lock.take()) {
    std::cerr << "another process computes in " << out.string()
              << ": wait for its end, stop it, or choose another directory\n";
    return kExitError;
  }
  const std::string obstacle = shorter.empty() ? "" : obstacle_to(RunDirectory(shorter), *parsed.value);
  if (!obstacle.empty()) {
    std::cerr << obstacle << "\n";
    return kExitInvalidInput;
  }
  if (!claim_directory(directory, *parsed.value)) {
    std::cerr << out.string() << " holds the run of another case: choose another directory\n";
    return kExitInvalidInput;
  }
  if (!shorter.empty()) directory.go_on_from(RunDirectory(shorter));
  print_choices_and_warnings(parsed);
  return exit_code_of(run_case(parsed, directory, end_seconds));
}

}  // namespace

int solve_case(const std::filesystem::path& case_file, const std::filesystem::path& out, double wall_seconds,
               const std::filesystem::path& shorter) {
  const double end_seconds = steady_seconds() + wall_seconds;
  catch_stop_signals();
  use_one_core_by_default();
  try {
    return lock_and_run(case_file, out, end_seconds, shorter);
  } catch (const AttemptWithdrawn&) {
    throw;
  } catch (const std::exception& error) {
    std::cerr << "capstan solve: " << error.what() << "\n";
    return kExitError;
  }
}

}  // namespace capstan
