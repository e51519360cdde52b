#pragma once
// How the process of a run ended, as its parent sees it.
#include <string>

namespace capstan {

/// How a run's process ended.
struct ProcessEnd {
  enum class How {
    exited,     ///< `number` is the exit code (schema/exit_codes.md)
    signalled,  ///< `number` is the signal that killed it
    lost,       ///< gone, and nobody knows how
  };
  How how = How::lost;
  int number = 0;
};

/// For people: "exit code 1", "killed by signal 9 (Killed)".
std::string describe(const ProcessEnd& end);

}  // namespace capstan
