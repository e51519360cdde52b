#include "runner/service/loop.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <iostream>

namespace capstan {
namespace {

constexpr long kTick = 250;    // ms: how often histories are read
constexpr long kPause = 5000;  // ms: after an error of the environment

/// SIGCHLD: a run has ended. SIGUSR1: someone has changed the queue.
sigset_t daemon_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (int signal : {SIGTERM, SIGINT, SIGCHLD, SIGUSR1}) sigaddset(&signals, signal);
  return signals;
}

/// The signal that came within that time, or -1.
int wait_for_signal(long milliseconds) {
  const sigset_t signals = daemon_signals();
  const timespec longest{milliseconds / 1000, milliseconds % 1000 * 1000000};
  return sigtimedwait(&signals, nullptr, &longest);
}

/// False if something could not be done.
bool tick(Service& service) try {
  service.tick();
  return true;
} catch (const std::exception& error) {
  std::clog << "capstan: " << error.what() << std::endl;
  return false;
}

}  // namespace

void hold_signals() {
  const sigset_t signals = daemon_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal(SIGPIPE, SIG_IGN);  // a client that goes away is no reason to end
}

void wake_loop() { kill(getpid(), SIGUSR1); }

bool work_until_terminated(Service& service) {
  for (bool draining = false;;) {
    const bool is_well = tick(service);
    if (draining && service.has_ended()) return service.is_idle();
    const int signal = wait_for_signal(is_well || draining ? kTick : kPause);
    if (signal != SIGTERM && signal != SIGINT) continue;
    draining = true;
    service.drain();
  }
}

}  // namespace capstan
