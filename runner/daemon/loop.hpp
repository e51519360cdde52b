#pragma once
// The daemon's life: ticks, and sleep until there is something to do.
#include <functional>

#include "runner/daemon/service.hpp"

namespace capstan {

/// To be called before any thread is made: from then on the signals of the daemon wait to be asked for by the
/// loop.
void hold_signals();

/// While it stands SIGTERM and SIGINT end the process at once, with exit code 0. That is for the start:
/// nothing runs yet, and the next start undoes what was half written to the database.
class EndAtOnce {
 public:
  EndAtOnce();
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

/// Ends the sleep of the loop, from any thread.
void wake_loop();

/// Works until SIGTERM or SIGINT, then has all runs write a checkpoint and end. An error of the environment
/// (a full disk) is said on standard error and tried again after a while. False if the end of a run could not
/// be recorded: the next daemon finds it in the run directory.
/// \param reopen_logs  called at SIGHUP
/// \param tidy  called often
bool work_until_terminated(Service& service, const std::function<void()>& reopen_logs,
                           const std::function<void()>& tidy);

}  // namespace capstan
