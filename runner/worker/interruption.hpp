#pragma once
// Turns the signals that ask a run to stop into a flag.

namespace capstan {

/// Installs handlers for the stop signals (stop_signals.hpp) and unblocks these. SIGHUP stays ignored if it
/// was ignored at the start: under nohup a run goes on when its terminal is closed.
void catch_stop_signals();

/// Whether such a signal has arrived.
bool is_interruption_wanted();

}  // namespace capstan
