#include "runner/worker/red_cell_case.hpp"

#include "solver/case/parse.hpp"

namespace capstan {
namespace {

Case red_cell(double Ca, const nlohmann::json& fidelity, double kt) {
  return parse_case({{"shape", "biconcave"},
                     {"law", "skalak"},
                     {"C", 5},
                     {"E_b", 0.015},
                     {"Ca", Ca},
                     {"V", 4},
                     {"fluid", "quasisteady"},
                     {"until", {{"kt", kt}}},
                     {"fidelity", fidelity}})
      .value.value();
}

}  // namespace

Case red_cell_case(double Ca, double dx, int nodes, double kdt, double kt) {
  return red_cell(Ca, {{"preset", "standard"}, {"dx", dx}, {"nodes", nodes}, {"kdt", kdt}}, kt);
}

Case standard_red_cell_case(double Ca, double kt) { return red_cell(Ca, "standard", kt); }

}  // namespace capstan
