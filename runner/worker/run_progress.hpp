#pragma once
// The progress of a run on standard error.
#include <unistd.h>

#include <chrono>

#include "solver/case/case.hpp"
#include "solver/observe/observables.hpp"

namespace capstan {

/// On a terminal one line, rewritten at each record; elsewhere one line for each unit of kt.
class RunProgress {
 public:
  explicit RunProgress(const Until& until) : until_(until) {}

  /// Prints kt, D_xy and the remaining time, extrapolated from the speed since the first call.
  void show(const Record& record);

 private:
  Until until_;
  bool on_terminal_ = isatty(STDERR_FILENO);
  double first_ = -1;  ///< kt of the first call; -1 before it
  double next_ = 0;    ///< kt of the next line, where there is no terminal
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace capstan
