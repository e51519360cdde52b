#include "solver/run_directory/run_ending.hpp"

#include "solver/run_directory/exit_code.hpp"

namespace capstan {

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
  for (const auto& [ending, word] : kWords<RunEnding>)
    if (exit_code_of(ending) == exit_code) return ending;
  return RunEnding::crashed;
}

}  // namespace capstan
