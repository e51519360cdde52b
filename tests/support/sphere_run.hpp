#pragma once
// Runs of a neo-Hookean sphere, V = 1, E_b = 0, with the quasisteady model.
#include <sstream>
#include <string>

#include "tests/support/history_of.hpp"

namespace capstan::testing {

/// \param fidelity  JSON: a preset's name in quotes, or an object
inline History sphere_run(double Ca, const std::string& fidelity, double kt) {
  std::ostringstream text;
  text << R"({"fluid": "quasisteady", "Ca": )" << Ca << R"(, "fidelity": )" << fidelity
       << R"(, "until": {"kt": )" << kt << R"(}, "outputs": {"shapes_every": 0}})";
  return history_of(text.str());
}

}  // namespace capstan::testing
