#include "solver/run_directory/run_ending.hpp"

#include "solver/run_directory/exit_code.hpp"

namespace capstan {

std::string_view to_string(RunEnding ending) {
  switch (ending) {
    case RunEnding::done:
      return "done";
    case RunEnding::failed:
      return "failed";
    case RunEnding::diverged:
      return "diverged";
    case RunEnding::interrupted:
      return "interrupted";
    case RunEnding::crashed:
      break;
  }
  return "crashed";
}

std::optional<RunEnding> parse_run_ending(std::string_view word) {
  for (const RunEnding ending : kRunEndings)
    if (to_string(ending) == word) return ending;
  return std::nullopt;
}

int exit_code_of(RunEnding ending) {
  switch (ending) {
    case RunEnding::done:
      return kExitDone;
    case RunEnding::failed:
      return kExitInvalidInput;
    case RunEnding::diverged:
      return kExitNoAnswer;
    case RunEnding::interrupted:
      return kExitInterrupted;
    case RunEnding::crashed:
      break;
  }
  return kExitError;
}

RunEnding run_ending_of(int exit_code) {
  for (const RunEnding ending : kRunEndings)
    if (exit_code_of(ending) == exit_code) return ending;
  return RunEnding::crashed;
}

}  // namespace capstan
