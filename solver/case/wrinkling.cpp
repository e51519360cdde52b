#include "solver/case/wrinkling.hpp"

#include <cmath>

#include "solver/case/grid_size.hpp"

namespace capstan {

bool is_nearly_round(const Case& c) {
  const auto [axis, across] = semi_axes(c);
  return c.shape != Shape::biconcave && std::abs(std::log(axis / across)) < std::log(1.25);
}

bool is_compressed(const Case& c) {
  return is_nearly_round(c) ? c.Ca < 0.04 && c.V < 5 : c.Ca < 0.3 && c.V < 10;
}

}  // namespace capstan
