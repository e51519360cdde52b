#include "runner/cli/program.hpp"
#include "runner/cli/revision.hpp"
#include "runner/worker/bench_report.hpp"
#include "runner/worker/benchmarks.hpp"
#include "runner/worker/compare.hpp"
#include "runner/worker/estimate.hpp"
#include "runner/worker/solve.hpp"
#include "runner/worker/tradeoff.hpp"

namespace {

/// Returns a function that runs the benchmark and prints its report.
auto printing(void (*benchmark)(capstan::BenchReport& report)) {
  return [benchmark](std::ostream& out, bool json) {
    capstan::BenchReport report(out, json);
    benchmark(report);
    report.finish();
  };
}

}  // namespace

int main(int argc, char** argv) {
  using namespace capstan;
  return run_program(
      argc, argv,
      {.solve = solve_case,
       .compare = compare_models,
       .estimate = estimate_study,
       .tradeoff = print_tradeoff,
       .benchmarks = {{"kernel", "the standard method against the memory's pace", "about two minutes",
                       printing(bench_kernel)},
                      {"cycle",
                       "a multigrid cycle on a uniform grid, a composite, a quarter; the parts of a step",
                       "about half a minute", printing(bench_cycle)},
                      {"cavity", "cycles in a lid-driven cavity by the relaxation factor: the paper's Fig. 2",
                       "about half a minute", printing(bench_cavity)},
                      {"table1", "the speed-up over the standard method for red cells: the paper's Table I",
                       "about half a minute", printing(bench_table1)},
                      {"fig18", "the same for spheres, by Ca and shear rate: the paper's Fig. 18",
                       "about half a minute", printing(bench_fig18)},
                      {"scaling", "time and memory by resolution, threads and cases side by side",
                       "about a minute, more on many cores", printing(bench_scaling)}},
       .revision = kRevision});
}
