#pragma once
// What accuracy costs: the same scenes with many numerical settings, each with its time and its error.
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/observe/observables.hpp"

namespace capstan {

/// A capsule to be followed to a time: a case file without flow model and fidelity.
struct TradeoffScene {
  std::string name;
  nlohmann::json capsule;
};

/// A row of results: the settings of a run ("fidelity" of a case file), and the one that it varies.
struct TradeoffSetting {
  std::string knob;  ///< "rung", or the setting that differs from rung 2
  nlohmann::json fidelity;
};

/// The settings with which a flow model runs every scene.
struct TradeoffModel {
  std::string fluid;
  std::vector<TradeoffSetting> rungs;  ///< coarse to fine; the last one is the reference
  std::vector<TradeoffSetting> knobs;
};

/// The scenes and settings of `capstan tradeoff`.
const std::vector<TradeoffScene>& tradeoff_scenes();
TradeoffModel boundary_integral_settings();
TradeoffModel lattice_settings();

/// What the errors of a scene and model refer to: the finest rung that is expected to take less than two
/// minutes and reached its end.
struct TradeoffReference {
  std::string fluid, setting;
  History history;
};

using TradeoffRow = nlohmann::ordered_json;

/// Runs a scene with all settings of a model and hands each row to `emit`, the reference first. Its columns:
///   scene, fluid, setting, knob
///   seconds      processor time
///   memory_mb    largest resident memory of the process during the run, about 15 of which it needs in any
///   case error_Q, error_D, error_theta   distance to the reference (distance.hpp); theta in radians motion,
///   stop, message           as in result.json; "refused" if a case cannot have this setting reference
///   setting of the reference
/// Numbers that are not known are null. Returns the reference; nothing if no rung reached its end.
std::optional<TradeoffReference> measure_tradeoff(const TradeoffScene& scene, const TradeoffModel& model,
                                                  const std::function<void(const TradeoffRow& row)>& emit);

/// A row with the knob "model": the distance of a lattice from boundary integrals.
TradeoffRow distance_of_models(const TradeoffScene& scene, const TradeoffReference& lattice,
                               const TradeoffReference& stokes);

/// `capstan tradeoff`: prints the rows as CSV, each as soon as it is known, or as one JSON document.
/// \param scenes  names of the scenes to run; none: all
/// \returns the exit code (schema/exit_codes.md)
int print_tradeoff(const std::vector<std::string>& scenes, bool json);

}  // namespace capstan
