#pragma once
// The benchmarks below `capstan bench`, one file each. They measure and add tables to the report.

namespace capstan {

class BenchReport;

/// Lattice updates per second of the standard method with 19 populations and with four moments, and of the
/// sweeps of the quasisteady model: in single and double precision, on grids that fit into the caches and on
/// one that does not, on one core and on all that OpenMP uses. Each with its share of the memory bandwidth,
/// which is measured, too.
void bench_kernel(BenchReport& report);

/// Time and contraction factor of a multigrid cycle at the paper's resolution, on a uniform grid, on the
/// composite grid and on a quarter of it; the time of each part of a step.
void bench_cycle(BenchReport& report);

/// Cycles of the paper's multigrid method in a lid-driven cavity by the relaxation factor (the paper's Fig.
/// 2).
void bench_cavity(BenchReport& report);

/// Speed-up over the standard method for red cells (the paper's Table I) and for spheres by Ca and shear rate
/// (its Fig. 18). Our time is that of whole runs; the standard method's is the number of its lattice updates
/// over its measured rate.
void bench_table1(BenchReport& report);
void bench_fig18(BenchReport& report);

/// Time and memory of a case against its resolution, against its threads, and against the number of cases
/// that run side by side.
void bench_scaling(BenchReport& report);

}  // namespace capstan
