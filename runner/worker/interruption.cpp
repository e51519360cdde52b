#include "runner/worker/interruption.hpp"

#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

volatile std::sig_atomic_t interruption_wanted = 0;

}  // namespace

void catch_stop_signals() {
  for (const int signal : kStopSignals)
    if (std::signal(signal, [](int) { interruption_wanted = 1; }) == SIG_IGN && signal == SIGHUP)
      std::signal(signal, SIG_IGN);
  unblock_stop_signals();
}

bool is_interruption_wanted() { return interruption_wanted != 0; }

}  // namespace capstan
