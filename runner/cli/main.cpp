#include "runner/cli/program.hpp"
#include "runner/cli/revision.hpp"
#include "runner/worker/bench_cycle.hpp"
#include "runner/worker/bench_kernel.hpp"
#include "runner/worker/bench_scaling.hpp"
#include "runner/worker/bench_table1.hpp"
#include "runner/worker/compare.hpp"
#include "runner/worker/estimate.hpp"
#include "runner/worker/solve.hpp"

int main(int argc, char** argv) {
  using namespace capstan;
  return run_program(
      argc, argv,
      {.solve = solve_case,
       .compare = compare_models,
       .estimate = estimate_study,
       .benchmarks = {{"kernel", "the standard method against the memory's pace", "about two minutes",
                       bench_kernel},
                      {"cycle",
                       "a multigrid cycle on a uniform grid, a composite, a quarter; the parts of a step",
                       "about half a minute", bench_cycle},
                      {"table1", "the speed-up over the standard method: the paper's Table I and Fig. 18",
                       "about half a minute", bench_table1},
                      {"scaling", "time and memory by resolution, threads and cases side by side",
                       "about a minute, more on many cores", bench_scaling}},
       .revision = kRevision});
}
