#include <cmath>

#include "runner/worker/bench_report.hpp"
#include "runner/worker/benchmarks.hpp"
#include "solver/baseline/lid_driven_cavity.hpp"

namespace capstan {
namespace {

nlohmann::ordered_json shown_cycles(const std::optional<int>& cycles) {
  return cycles ? nlohmann::ordered_json(*cycles) : nlohmann::ordered_json();
}

nlohmann::ordered_json cavity_row(int cells, double gamma) {
  constexpr double kRe = 0.05;  // the paper's
  constexpr int kMaxCycles = 3000;
  const CavityCycles counted = count_cavity_cycles(cells, kRe, gamma, {1e-5, 1e-8}, kMaxCycles);
  return {{"cells", cells},
          {"gamma", gamma},
          {"cycles_to_1e-5", shown_cycles(counted.until[0])},
          {"cycles_to_1e-8", shown_cycles(counted.until[1])},
          {"contraction", std::round(1000 * counted.contraction) / 1000}};
}

}  // namespace

void bench_cavity(BenchReport& report) {
  nlohmann::ordered_json rows;
  for (const double gamma : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1.0})
    rows.push_back(cavity_row(16, gamma));
  for (const int cells : {32, 64}) rows.push_back(cavity_row(cells, 0.8));
  report.add(
      "Fig. 2: W-cycles in a cube whose lid moves, Re = 0.05, until the velocity changes by less than a "
      "tolerance in a cycle; the paper's relaxation rates and its lattice viscosity 0.04",
      rows);
}

}  // namespace capstan
