#include "runner/worker/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>

#include "runner/worker/case_file.hpp"
#include "runner/worker/timed_run.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

struct Run {
  Record last;
  double seconds = 0;
};

std::optional<Run> run(const Case& c) {
  const TimedRun timed = timed_run(c);
  if (timed.outcome.stop == Stop::reached_end) return Run{timed.history.back(), timed.wall_seconds};
  std::cerr << to_string(c.fluid) << ": " << to_string(timed.outcome.stop) << ": " << timed.outcome.message
            << "\n";
  return std::nullopt;
}

struct Grid {
  double dx, box;
};
/// The box is doubled twice at one spacing, then the spacing is halved twice in the largest box.
constexpr std::array<Grid, 5> kGrids = {{{0.2, 6.4}, {0.2, 12.8}, {0.2, 25.6}, {0.1, 25.6}, {0.05, 25.6}}};
constexpr double kMaxStep = 0.02;  // so that the step in time is no part of the difference

/// The same case, of whatever fluid it is, in this one. \param Re of the fluid, if it has any
Case in_fluid(const Case& c, const char* fluid, double Re, const nlohmann::json& fidelity) {
  nlohmann::json object = to_json(c);
  object["fluid"] = fluid;
  object["Re"] = Re;
  object["fidelity"] = fidelity;
  return parse_case(object).value.value();
}

Case in_stokes_flow(const Case& c) { return in_fluid(c, "stokes", 0, {{"nodes", c.fidelity.nodes}}); }

Case on_lattice(const Case& c, const Grid& grid) {
  constexpr double kSmallRe = 0.05;  // for a case without inertia, which a lattice cannot do without
  Case on_grid = in_fluid(c, "quasisteady", c.Re > 0 ? c.Re : kSmallRe,
                          {{"nodes", c.fidelity.nodes}, {"dx", grid.dx}, {"box", grid.box}});
  on_grid.fidelity.kdt = std::min(on_grid.fidelity.kdt, kMaxStep);
  return on_grid;
}

void print_row(const char* fluid, const Grid* grid, const Run& run, const Record& stokes) {
  std::printf("| %-11s |", fluid);
  if (grid)
    std::printf(" %4g | %4g |", grid->dx, grid->box);
  else
    std::printf("      |      |");
  std::printf(" %.4f | %+6.2f %% | %+7.4f | %+7.4f | %7.1f |\n", run.last.D_xy,
              100 * (run.last.D_xy / stokes.D_xy - 1), run.last.theta / std::numbers::pi,
              (run.last.theta - stokes.theta) / std::numbers::pi, run.seconds);
  std::fflush(stdout);
}

/// The limit of no spacing, to which the delta function's width converges at first order, and of no walls,
/// whose effect falls with the cube of their distance. \param on values on kGrids
double limit(const std::array<double, 5>& on) { return on[4] + (on[4] - on[3]) + (on[2] - on[1]) / 7; }

double order_in_dx(const std::array<double, 5>& on) {
  return std::log2(std::abs((on[2] - on[3]) / (on[3] - on[4])));
}

nlohmann::ordered_json row_of(const char* fluid, const Grid* grid, const Run& run) {
  nlohmann::ordered_json row = {{"fluid", fluid}};
  if (grid) row["dx"] = grid->dx;
  if (grid) row["box"] = std::isfinite(grid->box) ? nlohmann::ordered_json(grid->box) : nullptr;
  row["D_xy"] = run.last.D_xy;
  row["theta"] = run.last.theta;
  row["seconds"] = run.seconds;
  return row;
}

void print_head(const std::filesystem::path& file, const Case& c) {
  std::printf("\n%s: %s, Ca = %g, V = %g, at kt = %g, %d nodes\n\n", file.stem().c_str(),
              to_string(c.shape).data(), c.Ca, c.V, c.until.kt, c.fidelity.nodes);
  std::printf("| fluid       |   dx |  box |   D_xy |    differs | θ/π      | differs | seconds |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
}

/// What was found, without `order_in_dx` if a run had no answer. As text each run is printed as it ends.
nlohmann::ordered_json compare(const std::filesystem::path& file, const Case& c, bool json) {
  nlohmann::ordered_json found = {
      {"file", file.string()}, {"case", to_json(c)}, {"runs", nlohmann::ordered_json::array()}};
  if (!json) print_head(file, c);
  const auto stokes = run(in_stokes_flow(c));
  if (!stokes) return found;
  const auto add = [&](const char* fluid, const Grid* grid, const Run& run) {
    found["runs"].push_back(row_of(fluid, grid, run));
    if (!json) print_row(fluid, grid, run, stokes->last);
  };
  add("stokes", nullptr, *stokes);
  std::array<double, 5> D_xy{}, theta{};
  for (std::size_t i = 0; i < kGrids.size(); ++i) {
    const auto lattice = run(on_lattice(c, kGrids[i]));
    if (!lattice) return found;
    add("quasisteady", &kGrids[i], *lattice);
    D_xy[i] = lattice->last.D_xy, theta[i] = lattice->last.theta;
  }
  Run extrapolated;
  extrapolated.last.D_xy = limit(D_xy), extrapolated.last.theta = limit(theta);
  const Grid none{0, INFINITY};
  add("limit", &none, extrapolated);
  found["order_in_dx"] = order_in_dx(D_xy);
  if (!json) std::printf("\norder in dx: %.2f\n", order_in_dx(D_xy));
  return found;
}

}  // namespace

int compare_models(const std::vector<std::filesystem::path>& case_files, bool json) {
  std::vector<Case> cases;
  for (const std::filesystem::path& file : case_files) {
    const ParsedCase parsed = read_case(file);
    print_faults(file, parsed.issues);
    if (parsed.value) cases.push_back(*parsed.value);
  }
  if (cases.size() < case_files.size()) return kExitInvalidInput;
  int worst = kExitDone;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (size_t n = 0; n < cases.size(); ++n) {
    all.push_back(compare(case_files[n], cases[n], json));
    if (!all.back().contains("order_in_dx")) worst = kExitNoAnswer;
  }
  if (json) std::cout << nlohmann::ordered_json{{"cases", all}}.dump(2) << '\n';
  return worst;
}

}  // namespace capstan
