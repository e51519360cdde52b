#include <omp.h>

#include <cmath>

#include "runner/worker/bench_report.hpp"
#include "runner/worker/benchmarks.hpp"
#include "runner/worker/standard_method.hpp"
#include "runner/worker/timed_run.hpp"
#include "solver/case/parse.hpp"

namespace capstan {
namespace {

/// The paper's spheres; small Ca end earlier because they reach their steady shape earlier.
struct Sphere {
  double Ca, kt;
};
constexpr Sphere kSpheres[] = {{0.00625, 0.5}, {0.0125, 1}, {0.025, 2}, {0.05, 4}, {0.1, 4}, {0.2, 4}};

constexpr double kPaperShearRate = 2e-4;                              // 1/s
constexpr double kShearRates[] = {2e-4, 4e-4, 8e-4, 1.2e-3, 1.6e-3};  // 1/s

Case case_of(const Sphere& sphere) {
  return parse_case({{"fluid", "quasisteady"},
                     {"Ca", sphere.Ca},
                     {"until", {{"kt", sphere.kt}}},
                     {"fidelity", "standard"}})
      .value.value();
}

double to_four_digits(double number) {
  const double scale = std::pow(10, 3 - std::floor(std::log10(number)));
  return std::round(number * scale) / scale;
}

/// At a larger shear rate and the same Re the paper's lattice viscosity is larger, and so is the strain of a
/// step of the standard method. The quasi-steady flow has no such step: its time is the same at all shear
/// rates.
nlohmann::ordered_json speed_up_row(const Sphere& sphere, const TimedRun& run, double shear_rate,
                                    StandardMethod standard) {
  standard.kdt *= shear_rate / kPaperShearRate;
  const double step = sphere.kt / double(run.steps);
  return {{"Ca", sphere.Ca},
          {"k", shear_rate},
          {"kt", sphere.kt},
          {"seconds", to_four_digits(run.cpu_seconds)},
          {"standard_seconds", to_four_digits(standard.seconds(sphere.kt))},
          {"step_ratio", to_four_digits(step / standard.kdt)},
          {"elastic_time_ratio", to_four_digits(sphere.Ca / standard.kdt)},
          {"speed_up", to_four_digits(standard.seconds(sphere.kt) / run.cpu_seconds)}};
}

}  // namespace

void bench_fig18(BenchReport& report) {
  omp_set_num_threads(1);
  const StandardMethod standard = standard_method_of_paper();
  nlohmann::ordered_json rows;
  for (const Sphere& sphere : kSpheres) {
    const TimedRun run = complete_run(case_of(sphere));
    for (const double shear_rate : kShearRates)
      rows.push_back(speed_up_row(sphere, run, shear_rate, standard));
  }
  report.add(
      "Fig. 18: neo-Hookean spheres, V = 1, dx = 0.1 a, 2562 nodes, one core. The standard method's time is "
      "extrapolated from its rate. step_ratio: mean step over a step of the standard method; "
      "elastic_time_ratio: Ca "
      "over k dt of a step of the standard method",
      rows);
}

}  // namespace capstan
