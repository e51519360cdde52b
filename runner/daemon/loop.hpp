#pragma once
// The main loop of the daemon: a tick of the service, then sleep until a signal or the next tick.
#include <functional>

#include "runner/daemon/service.hpp"

namespace capstan {

/// Blocks the signals that the loop waits for. Called before any thread is made, as threads inherit the mask.
void hold_signals();

/// While an object of this class exists, SIGTERM and SIGINT end the process at once, with exit code 0. For
/// the start, when no run exists yet: what was not committed to the database is undone at the next start.
class EndAtOnce {
 public:
  EndAtOnce();
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

/// Ends the sleep of the loop. From any thread.
void wake_loop();

/// Serves until SIGTERM or SIGINT, then asks all runs to write a checkpoint and waits for their end. An error
/// of the environment (a full disk) is printed to standard error, and the tick is tried again after a pause.
/// False if the end of a run could not be recorded: the next daemon finds it in the run directory.
/// \param reopen_logs  called at SIGHUP
/// \param tidy         called after each tick
bool work_until_terminated(Service& service, const std::function<void()>& reopen_logs,
                           const std::function<void()>& tidy);

}  // namespace capstan
