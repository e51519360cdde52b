#pragma once
// The benchmarks below `capstan bench`, one file each. They measure and add tables to the report.

namespace capstan {

class BenchReport;

/// Lattice updates a second of the standard method with 19 populations and with four moments, and of the
/// quasisteady model's sweeps; in single and double precision, in and out of the caches, on one core and on
/// all that OpenMP has. Each with the share of the memory bandwidth that is measured beside it.
void bench_kernel(BenchReport& report);

/// Time and contraction factor of a multigrid cycle at the paper's resolution, on a uniform grid, on the
/// composite grid and on a quarter of it; the time of each part of a step.
void bench_cycle(BenchReport& report);

/// Speed-up over the standard method (the paper's Table I and Fig. 18). Our time is that of whole runs; the
/// standard method's is the number of its lattice updates over its measured rate.
void bench_table1(BenchReport& report);

/// Time and memory of a case against its resolution, against its threads, and against the number of cases
/// that run side by side.
void bench_scaling(BenchReport& report);

}  // namespace capstan
