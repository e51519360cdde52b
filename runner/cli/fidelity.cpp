#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/render/preset_results.hpp"
#include "runner/render/table.hpp"
#include "solver/case/fidelity.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

ordered_json settings_of_presets() {
  ordered_json list = ordered_json::array();
  for (const auto& [name, purpose, settings] : fidelity_presets())
    list.push_back({{"preset", name},
                    {"nodes", settings.nodes},
                    {"dx", settings.dx},
                    {"scheme", to_string(settings.scheme)},
                    {"tolerance", settings.tolerance},
                    {"purpose", purpose}});
  return list;
}

ordered_json results_of_presets() {
  ordered_json list = ordered_json::array();
  for (const auto& [preset, fluid, seconds, error] : kPresetResults)
    list.push_back({{"preset", preset},
                    {"fluid", fluid},
                    {"seconds", seconds},
                    {"Q_error", error ? ordered_json(*error) : nullptr}});
  return list;
}

Table table_of(const ordered_json& objects) {
  Table table;
  for (const auto& [key, value] : objects.front().items()) table.columns.push_back(key);
  for (const ordered_json& object : objects) table.rows.emplace_back(object.begin(), object.end());
  return table;
}

}  // namespace

int print_presets(const PresetArguments& arguments) {
  const ordered_json presets = settings_of_presets(), results = results_of_presets();
  if (arguments.json)
    std::cout << ordered_json({{"presets", presets}, {"scene", kPresetScene}, {"results", results}}).dump(2)
              << '\n';
  else
    std::cout << as_text(table_of(presets)) << "\nmeasured: " << kPresetScene << '\n'
              << as_text(table_of(results));
  return kExitDone;
}

}  // namespace capstan
