#include "runner/worker/benchmarks.hpp"

#include <omp.h>

#include <cmath>
#include <thread>
#include <vector>

#include "runner/worker/bench_report.hpp"
#include "runner/worker/peak_memory.hpp"
#include "runner/worker/red_cell_case.hpp"
#include "runner/worker/timed_run.hpp"

namespace capstan {
namespace {

constexpr double kSecondsOfARun = 3;  // seconds of measurement for each number

double milliseconds_a_step(const TimedRun& run) { return std::round(1e5 * run.seconds_per_step()) / 100; }

void add_resolutions(BenchReport& report) {
  struct Resolution {
    double dx, kdt;
    int nodes;
  };
  nlohmann::ordered_json rows;
  for (const auto& [dx, kdt, nodes] :
       {Resolution{0.4, 0.05, 162}, {0.2, 0.03, 642}, {0.1, 0.04, 2562}, {0.05, 0.01, 10242}}) {
    restart_peak_memory();
    const TimedRun run = timed_run(red_cell_case(0.4, dx, nodes, kdt, 30), kSecondsOfARun);
    rows.push_back({{"dx", dx},
                    {"nodes", nodes},
                    {"ms a step", milliseconds_a_step(run)},
                    {"s for kt = 30", std::round(10 * 30 / kdt * 1e-3 * milliseconds_a_step(run)) / 10},
                    {"peak MB", std::round(peak_memory_mb().value_or(0))}});
  }
  report.add("Resolution: red cell, Ca = 0.4, V = 4, one core, from some seconds of steps", rows);
}

void add_threads(BenchReport& report) {
  nlohmann::ordered_json rows;
  for (int threads = 1; threads <= omp_get_num_procs(); ++threads) {
    omp_set_num_threads(threads);
    const double standard =
        milliseconds_a_step(timed_run(red_cell_case(0.4, 0.1, 2562, 0.04, 30), kSecondsOfARun));
    const double fine =
        milliseconds_a_step(timed_run(red_cell_case(0.4, 0.05, 10242, 0.01, 30), kSecondsOfARun));
    rows.push_back({{"threads", threads}, {"ms a step, dx = 0.1", standard}, {"dx = 0.05", fine}});
  }
  omp_set_num_threads(1);
  report.add("Threads of one case", rows);
}

void add_cases_side_by_side(BenchReport& report) {
  nlohmann::ordered_json rows;
  for (int cases = 1; cases <= omp_get_num_procs(); ++cases) {
    std::vector<long> rates(cases);  // steps a second of each
    std::vector<std::thread> threads;
    for (long& rate : rates)
      threads.emplace_back([&rate] {
        omp_set_num_threads(1);
        const TimedRun run = timed_run(red_cell_case(0.4, 0.1, 2562, 0.04, 30), kSecondsOfARun);
        rate = std::lround(double(run.steps) / run.wall_seconds);
      });
    for (std::thread& thread : threads) thread.join();
    long together = 0;
    for (long rate : rates) together += rate;
    rows.push_back({{"cases side by side", cases}, {"steps a second, all together", together}});
  }
  report.add("Cases side by side, dx = 0.1", rows);
}

}  // namespace

void bench_scaling(BenchReport& report) {
  omp_set_num_threads(1);
  add_resolutions(report);
  add_threads(report);
  add_cases_side_by_side(report);
}

}  // namespace capstan
