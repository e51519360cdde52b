#pragma once
// Makes a worker end together with the daemon that started it.

namespace capstan {

/// Environment variable in which a daemon gives its process id to the workers that it starts.
inline constexpr const char* kDaemonVariable = "CAPSTAN_DAEMON";

/// Called by a worker before anything else. If a daemon started the worker, the kernel kills it when the
/// thread of the daemon that started it ends. So it never works in the same run directory as a worker of the
/// next daemon.
void end_with_daemon();

}  // namespace capstan
