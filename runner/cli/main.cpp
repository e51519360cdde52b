#include "runner/bench/kernel.hpp"
#include "runner/cli/program.hpp"
#include "runner/execute/compare.hpp"
#include "runner/execute/worker.hpp"

int main(int argc, char** argv) {
  using namespace capstan;
  return run_program(
      argc, argv,
      {.solve = solve_case,
       .compare = compare_models,
       .benchmarks = {{"kernel", "the standard method against the memory's pace", bench_kernel}}});
}
