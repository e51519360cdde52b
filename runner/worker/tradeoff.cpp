#include "runner/worker/tradeoff.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "runner/render/table.hpp"
#include "runner/worker/peak_memory.hpp"
#include "runner/worker/timed_run.hpp"
#include "solver/case/parse.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/observe/distance.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kMaxExpectedSeconds = 120;
constexpr double kMaxSeconds =
    10 * kMaxExpectedSeconds;  // then a run is stopped: wall time, on a busy machine

/// {"dx": 0.2, "nodes": 642} as "dx 0.2, nodes 642".
std::string text_of(const json& fidelity) {
  std::string text;
  for (const auto& [key, value] : fidelity.items())
    text += (text.empty() ? "" : ", ") + key + " " +
            (value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

ParsedCase case_of(const TradeoffScene& scene, const TradeoffModel& model, const TradeoffSetting& setting) {
  json object = scene.capsule;
  object["fluid"] = model.fluid;
  object["fidelity"] = setting.fidelity;
  return parse_case(object);
}

/// What one setting gave. A case that cannot have the setting has issues and no run.
struct SettingRun {
  Issues issues;
  std::optional<TimedRun> run;
  std::optional<double> memory_mb;

  bool reached_end() const { return run && run->outcome.stop == Stop::reached_end; }
};

SettingRun run_setting(const ParsedCase& parsed) {
  SettingRun result{.issues = parsed.issues, .run = {}, .memory_mb = {}};
  if (!parsed.value) return result;
  const bool measures_memory = restart_peak_memory();
  result.run = timed_run(*parsed.value, kMaxSeconds);
  if (measures_memory) result.memory_mb = peak_memory_mb();
  return result;
}

/// Rounded to a number of decimals; null if it is not known.
ordered_json number(double value, int decimals) {
  const double unit = std::pow(10., decimals);
  return std::isfinite(value) ? ordered_json(std::round(value * unit) / unit) : ordered_json();
}

constexpr Distance kUnknown{.Q = NAN, .D_xy = NAN, .theta = NAN};

void add_errors(ordered_json& row, const Distance& error) {
  row["error_Q"] = number(error.Q, 6);
  row["error_D"] = number(error.D_xy, 6);
  row["error_theta"] = number(error.theta, 6);
}

void add_end(ordered_json& row, const SettingRun& run) {
  if (run.run) {
    row["motion"] = run.reached_end() ? ordered_json(to_string(run.run->verdict.motion)) : ordered_json();
    row["stop"] = to_string(run.run->outcome.stop);
    row["message"] = run.run->outcome.message;
    return;
  }
  row["motion"] = nullptr;
  row["stop"] = "refused";
  row["message"] = run.issues.front().message;
}

ordered_json row_of(const TradeoffScene& scene, const TradeoffModel& model, const TradeoffSetting& setting,
                    const SettingRun& run, const Distance& error) {
  ordered_json row = {{"scene", scene.name},
                      {"fluid", model.fluid},
                      {"setting", text_of(setting.fidelity)},
                      {"knob", setting.knob}};
  row["seconds"] = number(run.run ? run.run->cpu_seconds : NAN, 3);
  row["memory_mb"] = number(run.memory_mb.value_or(NAN), 0);
  add_errors(row, error);
  add_end(row, run);
  return row;
}

void print_csv_row(const ordered_json& row, bool with_header) {
  Table table;
  table.rows.emplace_back();
  for (const auto& [column, value] : row.items()) {
    table.columns.push_back(column);
    table.rows.front().push_back(value);
  }
  std::cout << (with_header ? as_csv(table) : csv_rows(table)) << std::flush;
}

/// Nothing if a name is none of a scene; then the reason is printed to standard error.
std::optional<std::vector<TradeoffScene>> scenes_named(const std::vector<std::string>& names) {
  if (names.empty()) return tradeoff_scenes();
  std::vector<TradeoffScene> scenes;
  for (const std::string& name : names) {
    const auto scene = std::ranges::find(tradeoff_scenes(), name, &TradeoffScene::name);
    if (scene == tradeoff_scenes().end()) {
      std::cerr << "no scene " << name << "; there are:";
      for (const TradeoffScene& known : tradeoff_scenes()) std::cerr << " " << known.name;
      std::cerr << "\n";
      return std::nullopt;
    }
    scenes.push_back(*scene);
  }
  return scenes;
}

}  // namespace

std::optional<TradeoffReference> measure_tradeoff(const TradeoffScene& scene, const TradeoffModel& model,
                                                  const std::function<void(const TradeoffRow&)>& emit) {
  std::optional<TradeoffReference> reference;
  const auto measure = [&](const TradeoffSetting& setting, const ParsedCase& parsed) {
    SettingRun run = run_setting(parsed);
    const bool is_compared = reference && run.reached_end();
    TradeoffRow row = row_of(scene, model, setting, run,
                             is_compared ? distance_between(run.run->history, reference->history) : kUnknown);
    if (!reference && run.reached_end())
      reference = {model.fluid, text_of(setting.fidelity), std::move(run.run->history)};
    row["reference"] = reference ? ordered_json(reference->setting) : ordered_json();
    emit(row);
  };
  for (auto rung = model.rungs.rbegin(); rung != model.rungs.rend(); ++rung) {
    const ParsedCase parsed = case_of(scene, model, *rung);
    if (parsed.value && run_cost(*parsed.value) < kMaxExpectedSeconds) measure(*rung, parsed);
  }
  for (const TradeoffSetting& knob : model.knobs) measure(knob, case_of(scene, model, knob));
  return reference;
}

TradeoffRow distance_of_models(const TradeoffScene& scene, const TradeoffReference& lattice,
                               const TradeoffReference& stokes) {
  TradeoffRow row = {{"scene", scene.name}, {"fluid", lattice.fluid}, {"setting", lattice.setting},
                     {"knob", "model"},     {"seconds", nullptr},     {"memory_mb", nullptr}};
  add_errors(row, distance_between(lattice.history, stokes.history));
  row.update({{"motion", nullptr}, {"stop", "reached_end"}, {"message", ""}});
  row["reference"] = stokes.setting;
  return row;
}

int print_tradeoff(const std::vector<std::string>& names, bool json) {
  const auto scenes = scenes_named(names);
  if (!scenes) return kExitInvalidInput;
  omp_set_num_threads(1);
  ordered_json rows = ordered_json::array();
  const auto emit = [&](const ordered_json& row) {
    if (!json) print_csv_row(row, rows.empty());
    rows.push_back(row);
  };
  for (const TradeoffScene& scene : *scenes) {
    const auto stokes = measure_tradeoff(scene, boundary_integral_settings(), emit);
    const auto lattice = measure_tradeoff(scene, lattice_settings(), emit);
    if (stokes && lattice) emit(distance_of_models(scene, *lattice, *stokes));
  }
  if (json) std::cout << ordered_json{{"runs", rows}}.dump(2) << '\n';
  return kExitDone;
}

}  // namespace capstan
