#include "runner/worker/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>

#include "runner/worker/case_file.hpp"
#include "runner/worker/timed_run.hpp"
#include "solver/observe/distance.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

struct Run {
  Record last;
  double seconds = 0;        ///< wall time
  double distance_of_Q = 0;  ///< to boundary integrals, over the whole run; 0 for their own
};

/// Nothing if the run did not reach its end; then the reason is printed to standard error.
/// \param stokes  the history of boundary integrals, which is set by their own run
std::optional<Run> run_to_end(const Case& c, History& stokes) {
  const TimedRun timed = timed_run(c);
  if (c.fluid == Fluid::stokes) stokes = timed.history;
  if (timed.outcome.stop == Stop::reached_end)
    return Run{timed.history.back(), timed.wall_seconds, distance_between(timed.history, stokes).Q};
  std::cerr << to_string(c.fluid) << ": " << to_string(timed.outcome.stop) << ": " << timed.outcome.message
            << "\n";
  return std::nullopt;
}

struct LatticeSize {
  double dx, box;  ///< spacing and edge
};
/// The box is doubled twice at one spacing, then the spacing is halved twice in the largest box.
constexpr std::array<LatticeSize, 5> kLattices = {
    {{0.2, 6.4}, {0.2, 12.8}, {0.2, 25.6}, {0.1, 25.6}, {0.05, 25.6}}};
constexpr double kMaxStep = 0.02;  // small enough that its error does not count in the comparison

/// The case with another flow model. \param Re  0 for boundary integrals
Case with_fluid(const Case& c, const char* fluid, double Re, const nlohmann::json& fidelity) {
  nlohmann::json object = to_json(c);
  object["fluid"] = fluid;
  object["Re"] = Re;
  object["fidelity"] = fidelity;
  return parse_case(object).value.value();
}

Case in_stokes_flow(const Case& c) { return with_fluid(c, "stokes", 0, {{"nodes", c.fidelity.nodes}}); }

Case on_lattice(const Case& c, const LatticeSize& lattice) {
  Case result = with_fluid(c, "quasisteady", c.Re,
                           {{"nodes", c.fidelity.nodes}, {"dx", lattice.dx}, {"box", lattice.box}});
  result.fidelity.kdt = std::min(result.fidelity.kdt, kMaxStep);
  return result;
}

void print_row(const char* fluid, const LatticeSize* lattice, const Run& run, const Record& stokes) {
  std::printf("| %-11s |", fluid);
  if (lattice)
    std::printf(" %4g | %4g |", lattice->dx, lattice->box);
  else
    std::printf("      |      |");
  std::printf(" %.4f | %+6.2f %% | %+7.4f | %+7.4f | %.4f | %7.1f |\n", run.last["D_xy"],
              100 * (run.last["D_xy"] / stokes["D_xy"] - 1), run.last["theta"] / std::numbers::pi,
              (run.last["theta"] - stokes["theta"]) / std::numbers::pi, run.distance_of_Q, run.seconds);
  std::fflush(stdout);
}

/// Richardson extrapolation to dx = 0 and an infinite box, as for an error of first order in dx; the effect
/// of the walls falls with the cube of their distance, so that doubling the box leaves an eighth. \param
/// values  on kLattices
double extrapolated(const std::array<double, 5>& values) {
  return values[4] + (values[4] - values[3]) + (values[2] - values[1]) / 7;
}

/// Observed order of convergence. \param values  on kLattices
double order_in_dx(const std::array<double, 5>& values) {
  return std::log2(std::abs((values[2] - values[3]) / (values[3] - values[4])));
}

nlohmann::ordered_json row_of(const char* fluid, const LatticeSize* lattice, const Run& run) {
  nlohmann::ordered_json row = {{"fluid", fluid}};
  if (lattice) row["dx"] = lattice->dx;
  if (lattice) row["box"] = std::isfinite(lattice->box) ? nlohmann::ordered_json(lattice->box) : nullptr;
  row["D_xy"] = run.last["D_xy"];
  row["theta"] = run.last["theta"];
  row["distance_of_Q"] = run.distance_of_Q;
  row["seconds"] = run.seconds;
  return row;
}

void print_head(const std::filesystem::path& file, const Case& c) {
  std::printf("\n%s: %s, Ca = %g, V = %g, at kt = %g, %d nodes\n\n", file.stem().c_str(),
              to_string(c.shape).data(), c.Ca, c.V, c.until.kt, c.fidelity.nodes);
  std::printf(
      "| fluid       |   dx |  box |   D_xy |    differs | θ/π      | differs | dist. Q | seconds |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
}

/// Runs one case with all models. As text each run is printed as it ends. Returns the JSON document; it has
/// no "order_in_dx" if a run did not reach its end.
nlohmann::ordered_json compare(const std::filesystem::path& file, const Case& c, bool json) {
  nlohmann::ordered_json found = {
      {"file", file.string()}, {"case", to_json(c)}, {"runs", nlohmann::ordered_json::array()}};
  if (!json) print_head(file, c);
  History history_in_stokes_flow;
  const auto stokes = run_to_end(in_stokes_flow(c), history_in_stokes_flow);
  if (!stokes) return found;
  const auto add = [&](const char* fluid, const LatticeSize* lattice, const Run& run) {
    found["runs"].push_back(row_of(fluid, lattice, run));
    if (!json) print_row(fluid, lattice, run, stokes->last);
  };
  add("stokes", nullptr, *stokes);
  std::array<double, 5> D_xy{}, theta{};
  for (std::size_t i = 0; i < kLattices.size(); ++i) {
    const auto lattice_run = run_to_end(on_lattice(c, kLattices[i]), history_in_stokes_flow);
    if (!lattice_run) return found;
    add("quasisteady", &kLattices[i], *lattice_run);
    D_xy[i] = lattice_run->last["D_xy"], theta[i] = lattice_run->last["theta"];
  }
  Run limit;
  limit.last["D_xy"] = extrapolated(D_xy), limit.last["theta"] = extrapolated(theta);
  const LatticeSize limit_size{0, INFINITY};
  add("limit", &limit_size, limit);
  found["order_in_dx"] = order_in_dx(D_xy);
  if (!json) std::printf("\norder in dx: %.2f\n", order_in_dx(D_xy));
  return found;
}

}  // namespace

int compare_models(const std::vector<std::filesystem::path>& case_files, bool json) {
  std::vector<Case> cases;
  for (const std::filesystem::path& file : case_files) {
    const ParsedCase parsed = read_case(file);
    print_case_issues(file, parsed.issues);
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
