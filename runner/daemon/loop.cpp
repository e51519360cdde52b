#include "runner/daemon/loop.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <ctime>
#include <iostream>
#include <span>

namespace capstan {
namespace {

constexpr long kTick = 250;    // ms between two ticks
constexpr long kPause = 5000;  // ms after a tick that failed

constexpr std::array kEndingSignals = {SIGTERM, SIGINT};

/// SIGCHLD: a run has ended. SIGUSR1: a client has changed the queue. SIGHUP: the logs were rotated.
constexpr std::array kDaemonSignals = {SIGTERM, SIGINT, SIGCHLD, SIGUSR1, SIGHUP};

sigset_t set_of(std::span<const int> list) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : list) sigaddset(&signals, signal);
  return signals;
}

/// Returns the signal that came within that time, or -1.
int wait_for_signal(long milliseconds) {
  const sigset_t signals = set_of(kDaemonSignals);
  const timespec max_wait{milliseconds / 1000, milliseconds % 1000 * 1000000};
  return sigtimedwait(&signals, nullptr, &max_wait);
}

/// False if an error was reported.
bool tick(Service& service) try {
  service.tick();
  return true;
} catch (const DatabaseDamaged& error) {
  service.report_damage(error.what());
  std::clog << "capstan: " << error.what() << std::endl;
  return false;
} catch (const std::exception& error) {
  std::clog << "capstan: " << error.what() << std::endl;
  return false;
}

}  // namespace

void hold_signals() {
  const sigset_t signals = set_of(kDaemonSignals);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal(SIGPIPE, SIG_IGN);  // a client that closes its connection does not end the daemon
}

EndAtOnce::EndAtOnce() {
  for (const int signal : kEndingSignals) std::signal(signal, [](int) { _exit(0); });
  const sigset_t signals = set_of(kEndingSignals);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

EndAtOnce::~EndAtOnce() {
  const sigset_t signals = set_of(kEndingSignals);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  for (const int signal : kEndingSignals) std::signal(signal, SIG_DFL);
}

void wake_loop() { kill(getpid(), SIGUSR1); }

bool work_until_terminated(Service& service, const std::function<void()>& reopen_logs,
                           const std::function<void()>& tidy) {
  for (bool draining = false;;) {
    const bool succeeded = tick(service);
    if (draining && service.has_ended()) return service.is_idle();
    const int signal = wait_for_signal(succeeded || draining ? kTick : kPause);
    if (signal == SIGHUP) reopen_logs();
    tidy();
    if (signal != SIGTERM && signal != SIGINT) continue;
    draining = true;
    service.drain();
  }
}

}  // namespace capstan
