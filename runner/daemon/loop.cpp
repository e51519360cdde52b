#include "runner/daemon/loop.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <ctime>
#include <iostream>
#include <span>

namespace capstan {
namespace {

constexpr long kTick = 250;    // ms: how often histories are read
constexpr long kPause = 5000;  // ms: after an error of the environment

constexpr std::array kEndingSignals = {SIGTERM, SIGINT};

/// SIGCHLD: a run has ended. SIGUSR1: someone has changed the queue. SIGHUP: the logs were moved away.
constexpr std::array kDaemonSignals = {SIGTERM, SIGINT, SIGCHLD, SIGUSR1, SIGHUP};

sigset_t set_of(std::span<const int> list) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : list) sigaddset(&signals, signal);
  return signals;
}

/// The signal that came within that time, or -1.
int wait_for_signal(long milliseconds) {
  const sigset_t signals = set_of(kDaemonSignals);
  const timespec longest{milliseconds / 1000, milliseconds % 1000 * 1000000};
  return sigtimedwait(&signals, nullptr, &longest);
}

/// False if something could not be done.
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
  signal(SIGPIPE, SIG_IGN);  // a client that goes away is no reason to end
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
    const bool is_well = tick(service);
    if (draining && service.has_ended()) return service.is_idle();
    const int signal = wait_for_signal(is_well || draining ? kTick : kPause);
    if (signal == SIGHUP) reopen_logs();
    tidy();
    if (signal != SIGTERM && signal != SIGINT) continue;
    draining = true;
    service.drain();
  }
}

}  // namespace capstan
