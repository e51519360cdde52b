// The scenes and settings of `capstan tradeoff`.
#include "runner/worker/tradeoff.hpp"

namespace capstan {
namespace {

using nlohmann::json;

TradeoffScene sphere(const char* name, double Ca, double V, double E_b, double kt) {
  return {name, {{"Ca", Ca}, {"V", V}, {"E_b", E_b}, {"until", {{"kt", kt}}}}};
}

TradeoffScene spheroid(const char* name, const char* shape, double aspect, double Ca, double V, double E_b,
                       double kt) {
  TradeoffScene scene = sphere(name, Ca, V, E_b, kt);
  scene.capsule["shape"] = shape;
  scene.capsule["aspect"] = aspect;
  return scene;
}

/// The paper's red blood cell.
TradeoffScene red_cell(const char* name, double Ca, double V, double kt) {
  TradeoffScene scene = sphere(name, Ca, V, 0.015, kt);
  scene.capsule.update({{"shape", "biconcave"}, {"law", "skalak"}, {"C", 5}});
  return scene;
}

TradeoffSetting rung(const json& fidelity) { return {"rung", fidelity}; }

/// Rung 2 with other settings.
TradeoffSetting varied(const char* knob, json rung_2, const json& settings) {
  rung_2.update(settings);
  return {knob, rung_2};
}

/// The tolerance is that of the presets.
json lattice(double dx, int nodes) {
  return {{"dx", dx}, {"nodes", nodes}, {"tolerance", usual_tolerance(dx)}};
}

}  // namespace

const std::vector<TradeoffScene>& tradeoff_scenes() {
  static const std::vector<TradeoffScene> scenes = {
      sphere("sphere_V1", 0.1, 1, 0, 10),
      sphere("sphere_V5", 0.1, 5, 0, 10),
      sphere("sphere_V0.2", 0.1, 0.2, 0, 10),
      sphere("small_Ca", 0.0125, 1, 0.005, 5),
      spheroid("oblate", "oblate", 0.5, 0.2, 1, 0, 10),
      spheroid("stiff_bending", "prolate", 2, 0.2, 2, 0.1, 6),
      red_cell("red_cell_0.25_4", 0.25, 4, 15),
      red_cell("red_cell_0.4_2", 0.4, 2, 12),
      red_cell("red_cell_0.4_4", 0.4, 4, 15),
  };
  return scenes;
}

TradeoffModel boundary_integral_settings() {
  const json rung_2 = {{"nodes", 642}};
  TradeoffModel model{
      "stokes",
      {rung({{"nodes", 162}}), rung(rung_2), rung({{"nodes", 2562}}), rung({{"nodes", 10242}})},
      {}};
  const auto vary = [&](const char* knob, const json& settings) {
    model.knobs.push_back(varied(knob, rung_2, settings));
  };
  for (double tolerance : {1e-2, 1e-3, 1e-5}) vary("tolerance", {{"tolerance", tolerance}});
  vary("stepper", {{"stepper", "ab2"}});
  for (double kdt : {0.05, 0.02, 0.005}) vary("kdt", {{"stepper", "ab2"}, {"kdt", kdt}});
  vary("symmetry", {{"symmetry", "none"}});
  return model;
}

TradeoffModel lattice_settings() {
  const json rung_2 = lattice(0.2, 642);
  TradeoffModel model{
      "quasisteady",
      {rung(lattice(0.4, 162)), rung(rung_2), rung(lattice(0.1, 2562)), rung(lattice(0.05, 10242))},
      {}};
  const auto vary = [&](const char* knob, const json& settings) {
    model.knobs.push_back(varied(knob, rung_2, settings));
  };
  for (double dx : {0.4, 0.1}) vary("dx", {{"dx", dx}});
  for (int nodes : {162, 2562}) vary("nodes", {{"nodes", nodes}});
  for (double tolerance : {1e-2, 1e-3, 1e-4}) vary("tolerance", {{"tolerance", tolerance}});
  for (const char* stepper : {"ab2", "rkc2"}) vary("stepper", {{"stepper", stepper}});
  for (double kdt : {0.08, 0.04, 0.02, 0.01}) vary("kdt", {{"stepper", "ab2"}, {"kdt", kdt}});
  for (double kdt : {0.04, 0.02})
    vary("kdt, tolerance", {{"stepper", "ab2"}, {"kdt", kdt}, {"tolerance", 1e-2}});
  for (double box : {6.4, 25.6}) vary("box", {{"box", box}});
  vary("precision", {{"precision", "double"}});
  vary("symmetry", {{"symmetry", "none"}});
  return model;
}

}  // namespace capstan
