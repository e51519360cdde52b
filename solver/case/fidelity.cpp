#include "solver/case/fidelity.hpp"

namespace capstan {

const std::vector<FidelityPreset>& fidelity_presets() {
  static const std::vector<FidelityPreset> presets = {
      {"fast",
       "classes and trends in under a minute a case",
       {.dx = 0.2, .nodes = 642, .tolerance = usual_tolerance(0.2)}},
      {"standard",
       "the paper's resolution with converged flow",
       {.dx = 0.1, .nodes = 2562, .tolerance = usual_tolerance(0.1)}},
      {"fine", "half the paper's spacing", {.dx = 0.05, .nodes = 10242, .tolerance = usual_tolerance(0.05)}},
      {"paper",
       "the paper's resolution and its own multigrid settings",
       {.dx = 0.1, .nodes = 2562, .tolerance = 1e-5, .scheme = Scheme::paper}},
  };
  return presets;
}

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  names.reserve(fidelity_presets().size());
  for (const FidelityPreset& preset : fidelity_presets()) names.push_back(preset.name);
  return names;
}

const FidelityPreset* find_preset(std::string_view name) {
  for (const FidelityPreset& preset : fidelity_presets())
    if (preset.name == name) return &preset;
  return nullptr;
}

}  // namespace capstan
