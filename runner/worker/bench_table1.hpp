#pragma once

namespace capstan {

class BenchReport;

/// The speed-up over the standard method (the paper's Table I and Fig. 18): our time for whole runs, and the
/// time that the standard method would take, from its measured rate of updates. What `capstan bench table1`
/// prints.
void bench_table1(BenchReport& report);

}  // namespace capstan
