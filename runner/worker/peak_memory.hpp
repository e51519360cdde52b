#pragma once
#include <optional>

namespace capstan {

/// Starts a new measurement of peak_memory_mb(). False if the kernel does not allow it.
bool restart_peak_memory();

/// Largest resident memory of this process since the last restart that succeeded, or since its start; nothing
/// if it is not known.
std::optional<double> peak_memory_mb();

}  // namespace capstan
