#include "runner/worker/estimate.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <set>

#include "runner/render/table.hpp"
#include "runner/study/shown_value.hpp"
#include "runner/worker/bench_report.hpp"
#include "runner/worker/cost_model.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

std::string duration_in_words(double seconds) {
  if (seconds < 90) return shown_value(std::round(10 * seconds) / 10) + " s";
  if (seconds < 90 * 60) return shown_value(std::round(seconds / 6) / 10) + " min";
  return shown_value(std::round(seconds / 360) / 10) + " h";
}

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

}  // namespace

int estimate_study(const Study& study, int cores, bool json) {
  omp_set_num_threads(1);
  const std::vector<double> seconds = estimated_seconds(study.cases);
  const double total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  const double longest = *std::ranges::max_element(seconds);
  // When the queue is empty, cores wait for the last cases: for half a case on average.
  const double wall = std::max(longest, total / cores + (cores > 1 ? longest / 2 : 0));
  const nlohmann::ordered_json rows = case_rows(study, seconds);
  if (json) {
    std::cout << nlohmann::ordered_json{{"cases", rows},
                                        {"core_seconds", total},
                                        {"cores", cores},
                                        {"seconds", wall}}
                     .dump(2)
              << '\n';
    return kExitDone;
  }
  BenchReport(std::cout, false).add(study.name + ": seconds of one core", rows, columns_of_axes(study));
  std::cout << '\n'
            << seconds.size() << (seconds.size() == 1 ? " case: " : " cases: ") << duration_in_words(total)
            << " of one core, about " << duration_in_words(wall) << " on " << cores
            << (cores == 1 ? " core\n" : " cores\n");
  return kExitDone;
}

}  // namespace capstan
