#pragma once
// The signals that ask a run to write a checkpoint and end.
#include <array>
#include <csignal>

namespace capstan {

/// The daemon sends SIGTERM, a terminal SIGINT, one that is closed SIGHUP, Slurm SIGUSR1 (--signal=USR1).
inline constexpr std::array kStopSignals = {SIGTERM, SIGINT, SIGHUP, SIGUSR1};

inline sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kStopSignals) sigaddset(&signals, signal);
  return signals;
}

/// The daemon starts a run with these signals blocked, so that none ends it before it can write a checkpoint.
/// To be called once the handlers are installed: a signal that came earlier is delivered now.
inline void unblock_stop_signals() {
  const sigset_t signals = stop_signals();
  sigprocmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace capstan
