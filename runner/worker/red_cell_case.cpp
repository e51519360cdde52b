#include "runner/worker/red_cell_case.hpp"

#include "solver/case/parse.hpp"

namespace capstan {

Case red_cell_case(double Ca, double dx, int nodes, double kdt, double kt) {
  return parse_case({{"shape", "biconcave"},
                     {"law", "skalak"},
                     {"C", 5},
                     {"E_b", 0.015},
                     {"Ca", Ca},
                     {"V", 4},
                     {"fluid", "quasisteady"},
                     {"until", {{"kt", kt}}},
                     {"fidelity", {{"preset", "standard"}, {"dx", dx}, {"nodes", nodes}, {"kdt", kdt}}}})
      .value.value();
}

}  // namespace capstan
