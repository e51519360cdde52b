#pragma once

namespace capstan {

class BenchReport;

/// Time and memory against resolution, against threads, and against cases side by side. What `capstan bench
/// scaling` prints.
void bench_scaling(BenchReport& report);

}  // namespace capstan
