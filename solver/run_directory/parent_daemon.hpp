#pragma once
// How a worker that was started by a daemon ends together with that daemon.

namespace capstan {

/// Environment variable in which a daemon gives its process id to the workers that it starts.
inline constexpr const char* kDaemonVariable = "CAPSTAN_DAEMON";

/// Called by a worker before anything else. If a daemon started it, the kernel kills it when the daemon's
/// thread that started it ends: so a successor's worker never shares a run directory with it.
void end_with_daemon();

}  // namespace capstan
