#pragma once
// The speed of the standard method, against which speed-ups are stated: what `capstan bench kernel` does.

namespace capstan {

class BenchReport;

/// Million updates a second of both baselines, in single and double precision, in and out of the caches, on
/// one core and on all that OpenMP has, each with its share of the memory bandwidth measured beside it.
/// Prints a table, or JSON.
void bench_kernel(BenchReport& report);

}  // namespace capstan
