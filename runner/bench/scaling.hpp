#pragma once

namespace capstan {

/// Time and memory against resolution, against threads, and against cases side by side. What `capstan bench
/// scaling` prints. \return the exit code
int bench_scaling(bool json);

}  // namespace capstan
