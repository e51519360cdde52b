#include "runner/worker/estimate.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <set>

#include "runner/render/duration.hpp"
#include "runner/worker/bench_report.hpp"
#include "runner/worker/cost_model.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

/// One row a case: the values of the axes as the study asks for them at the case's first point, its flow
/// model and its time.
nlohmann::ordered_json case_rows(const Study& study, const std::vector<double>& seconds) {
  nlohmann::ordered_json rows;
  for (std::size_t number = 0; number < seconds.size(); ++number) {
    const auto point = std::ranges::find(study.points, number) - study.points.begin();
    const nlohmann::json asked = study.asked_at(static_cast<std::size_t>(point));
    nlohmann::ordered_json& row = rows.emplace_back(nlohmann::ordered_json::object());
    for (const Axis& axis : study.axes) row[axis.parameter()] = asked[axis.parameter()];
    row["fluid"] = to_string(study.cases[number].fluid);
    row["seconds"] = std::round(100 * seconds[number]) / 100;
  }
  return rows;
}

/// The axes stand in the first columns.
std::set<std::size_t> columns_of_axes(const Study& study) {
  std::set<std::size_t> columns;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) columns.insert(axis);
  return columns;
}

nlohmann::ordered_json document_of(const nlohmann::ordered_json& rows, double core_seconds, int cores,
                                   double wall) {
  return {{"cases", rows}, {"core_seconds", core_seconds}, {"cores", cores}, {"seconds", wall}};
}

void print_text(const Study& study, const nlohmann::ordered_json& rows, double core_seconds, int cores,
                double wall) {
  BenchReport(std::cout, false).add(study.name + ": seconds of one core", rows, columns_of_axes(study));
  std::cout << '\n'
            << rows.size() << (rows.size() == 1 ? " case: " : " cases: ") << duration_in_words(core_seconds)
            << " of one core, about " << duration_in_words(wall) << " on " << cores
            << (cores == 1 ? " core\n" : " cores\n");
  if (study.boundary || study.refinement)
    std::cout << "These are its first cases; further ones follow where the motion changes.\n";
}

}  // namespace

int estimate_study(const Study& study, int cores, bool json) {
  omp_set_num_threads(1);
  const std::vector<double> seconds = estimated_seconds(study.cases);
  const double core_seconds = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  const double wall = wall_seconds(seconds, cores);
  const nlohmann::ordered_json rows = case_rows(study, seconds);
  if (json)
    std::cout << document_of(rows, core_seconds, cores, wall).dump(2) << '\n';
  else
    print_text(study, rows, core_seconds, cores, wall);
  return kExitDone;
}

}  // namespace capstan
