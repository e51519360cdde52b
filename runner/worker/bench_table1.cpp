#include "runner/worker/benchmarks.hpp"

#include <omp.h>

#include <cmath>

#include "runner/worker/bench_report.hpp"
#include "runner/worker/red_cell_case.hpp"
#include "runner/worker/standard_method.hpp"
#include "runner/worker/timed_run.hpp"

namespace capstan {
namespace {

double to_whole(double number) { return std::round(number); }
double to_tenths(double number) { return std::round(10 * number) / 10; }

void add_baselines(const StandardMethod& paper, const StandardMethod& best, BenchReport& report) {
  nlohmann::ordered_json rows;
  for (const auto& [name, standard] :
       {std::pair{"the paper's step, 19 populations", paper}, std::pair{"its own best, 4 moments", best}})
    rows.push_back({{"standard method", name},
                    {"k dt", standard.kdt},
                    {"MLUPS", to_whole(1e-6 * standard.speed.updates)},
                    {"share of roofline", std::round(100 * standard.speed.share()) / 100}});
  report.add("The standard method on 128^3 cells, double precision, one core: a measured stretch of steps",
             rows);
}

void add_red_cells(const StandardMethod& paper, const StandardMethod& best, BenchReport& report) {
  constexpr double kPaperSpeedUps[] = {7.4, 19.3, 35.2};
  nlohmann::ordered_json rows;
  int row = 0;
  for (double Ca : {0.25, 0.4, 0.75}) {
    const TimedRun run = complete_run(standard_red_cell_case(Ca, 30));
    rows.push_back({{"Ca", Ca},
                    {"seconds", to_tenths(run.cpu_seconds)},
                    {"motion", to_string(run.verdict.motion)},
                    {"standard, s", to_whole(paper.seconds(30))},
                    {"speed-up", to_whole(paper.seconds(30) / run.cpu_seconds)},
                    {"the paper's", kPaperSpeedUps[row++]},
                    {"standard at its best, s", to_whole(best.seconds(30))},
                    {"speed-up over it", to_whole(best.seconds(30) / run.cpu_seconds)}});
  }
  report.add(
      "Table I: red cell, V = 4, to kt = 30, dx = 0.1 a, 2562 nodes, steps as the program chooses them. The "
      "standard method's time "
      "is "
      "extrapolated from its rate",
      rows);
}

}  // namespace

void bench_table1(BenchReport& report) {
  omp_set_num_threads(1);
  const StandardMethod paper = standard_method_of_paper(), best = standard_method_at_its_best();
  add_baselines(paper, best, report);
  add_red_cells(paper, best, report);
}

}  // namespace capstan
