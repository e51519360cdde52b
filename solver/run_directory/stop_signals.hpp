#pragma once
// The signals that ask a run to write a checkpoint and end.
#include <array>
#include <csignal>

namespace capstan {

/// SIGTERM comes from the daemon, SIGINT from Ctrl-C, SIGHUP from a terminal that is closed. SIGUSR1 is for
/// batch systems that announce the end of a job with it.
inline constexpr std::array kStopSignals = {SIGTERM, SIGINT, SIGHUP, SIGUSR1};

inline sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kStopSignals) sigaddset(&signals, signal);
  return signals;
}

/// Called by a run once it has installed its handlers. The daemon starts a run with these signals blocked, so
/// that none of them ends the run before it can write a checkpoint. A signal that arrived while they were
/// blocked is delivered now.
inline void unblock_stop_signals() {
  const sigset_t signals = stop_signals();
  sigprocmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace capstan
