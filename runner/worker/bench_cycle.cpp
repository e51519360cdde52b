#include "runner/worker/benchmarks.hpp"

#include <omp.h>

#include <cmath>

#include "runner/worker/bench_report.hpp"
#include "runner/worker/red_cell_case.hpp"
#include "runner/worker/timed_run.hpp"
#include "solver/baseline/best_time.hpp"
#include "solver/fluid/quasisteady/membrane_coupling.hpp"
#include "solver/fluid/quasisteady/quasisteady_flow.hpp"
#include "solver/membrane/membrane.hpp"
#include "solver/mesh/shapes.hpp"

namespace capstan {
namespace {

constexpr double kSpan = 1;  // seconds of measurement for each number

/// A red blood cell at the paper's resolution, sheared by 0.1, and its membrane forces.
struct Scene {
  Case red = red_cell_case(0.4, 0.1, 2562, 0.04, 10);
  Icosphere sphere = make_icosphere(4);
  Points initial = initial_positions(red, sphere), positions = initial, forces;
  Membrane membrane{red, sphere.mesh, initial, Orbits::of(initial)};

  Scene() {
    positions.row(0) += 0.1 * initial.row(1);
    membrane.forces(positions, forces);
  }
  Orbits orbits(bool is_quarter) const {
    return is_quarter ? Orbits::of(initial) : Orbits::without_symmetry(int(initial.cols()));
  }
};

double milliseconds(double seconds) { return std::round(1e5 * seconds) / 100; }
double with_three_decimals(double number) { return std::round(1000 * number) / 1000; }

/// Norms of the error at the vertices after 0 to 4 cycles that start from the undisturbed shear flow.
/// \param exact  the solution, 3 x #V
std::vector<double> errors_of_cycles(const Scene& scene, const Orbits& orbits, QuasisteadyOptions options,
                                     const Points& exact) {
  options.tolerance = 1e300;  // so that solve() stops after one cycle
  QuasisteadyFlow<float> flow(scene.sphere.mesh, orbits, options);
  Points u = Points::Zero(3, exact.cols());
  u.row(0) = scene.positions.row(1);
  std::vector<double> errors = {(u - exact).norm()};
  for (int cycle = 0; cycle < 4; ++cycle) {
    flow.solve(0, scene.positions, scene.forces, u);
    errors.push_back((u - exact).norm());
  }
  return errors;
}

/// Time of a cycle, and the factors by which it reduces the error against a flow solved to a tolerance of
/// 1e-6.
nlohmann::ordered_json cycle_row(const Scene& scene, const std::string& name, bool is_uniform,
                                 bool is_quarter, double V) {
  const QuasisteadyOptions options{.Re = 0, .V = V, .tolerance = 1e-6, .is_uniform = is_uniform};
  const Orbits orbits = scene.orbits(is_quarter);
  QuasisteadyFlow<float> flow(scene.sphere.mesh, orbits, options);
  Points exact;
  flow.solve(0, scene.positions, scene.forces, exact);
  const std::vector<double> errors = errors_of_cycles(scene, orbits, options, exact);
  long cells = 0;
  for (const auto& grid : flow.grids()) cells += grid.box().cells();
  return {{"grid", name},
          {"V", V},
          {"cells", cells},
          {"ms a cycle", milliseconds(best_time(kSpan, [&] { flow.cycle(); }))},
          {"first contraction", with_three_decimals(errors[1] / errors[0])},
          {"mean of four", with_three_decimals(std::pow(errors[4] / errors[0], 0.25))}};
}

void add_cycles(const Scene& scene, BenchReport& report) {
  nlohmann::ordered_json rows;
  for (double V : {1.0, 4.0}) {
    rows.push_back(cycle_row(scene, "uniform 128^3", true, false, V));
    rows.push_back(cycle_row(scene, "composite", false, false, V));
    rows.push_back(cycle_row(scene, "composite, a quarter", false, true, V));
  }
  report.add("One W-cycle around a red cell, dx = 0.1 a, box 12.8 a, single precision", rows);
}

void add_parts_of_a_step(const Scene& scene, BenchReport& report) {
  const GridGeometry grid{Vec3::Constant(0.05), 0.1};
  MembraneCoupling coupling(grid, scene.sphere.mesh, scene.orbits(true), 4, std::nullopt);
  ViscosityField viscosity(grid, scene.sphere.mesh, scene.orbits(true));
  QuasisteadyFlow<float> flow(scene.sphere.mesh, scene.orbits(true), {.V = 4});
  Points forces, u;
  flow.solve(0, scene.positions, scene.forces, u);
  coupling.place(scene.positions);
  VectorField on_grid;
  ScalarField ratio;
  ratio.reset(coupling.touched());

  nlohmann::ordered_json rows;
  const auto add = [&](const char* part, double seconds) {
    rows.push_back({{"part", part}, {"ms", milliseconds(seconds)}});
  };
  add("forces of the membrane", best_time(kSpan, [&] { scene.membrane.forces(scene.positions, forces); }));
  add("to the grid and back", best_time(kSpan, [&] {
        coupling.place(scene.positions);
        coupling.spread(scene.forces, 1, on_grid);
        coupling.read(on_grid, u);
      }));
  add("viscosity field",
      best_time(kSpan, [&] { viscosity.update(scene.positions, layer_viscosity(4), ratio); }));
  add("one cycle", best_time(kSpan, [&] { flow.cycle(); }));
  const TimedRun run = timed_run(scene.red);
  add("a step, mean of a run to kt = 10, without the first", run.seconds_per_step());
  report.add("A step at the paper's resolution (2562 nodes, V = 4)", rows);
}

}  // namespace

void bench_cycle(BenchReport& report) {
  omp_set_num_threads(1);
  const Scene scene;
  add_cycles(scene, report);
  add_parts_of_a_step(scene, report);
}

}  // namespace capstan
