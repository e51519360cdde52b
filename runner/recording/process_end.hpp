#pragma once
// End of a run's process, as its parent observes it.
#include <string>

namespace capstan {

struct ProcessEnd {
  enum class How {
    exited,     ///< `number` is the exit code (schema/exit_codes.md)
    signalled,  ///< `number` is the signal that killed it
    lost,       ///< no longer there; its status is unknown
    not_begun,  ///< the run was never begun, as a cluster did not take or keep its job
  };
  How how = How::lost;
  int number = 0;
  std::string reason = {};  ///< a sentence that says more than the number; may be empty
};

/// Description for people: "exit code 1", "killed by signal 9 (Killed)".
std::string describe(const ProcessEnd& end);

}  // namespace capstan
