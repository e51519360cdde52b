#pragma once
#include "solver/fluid/lbm/collision.hpp"

namespace capstan::testing {

/// Rates that are all near 1 and all different: for whatever must hold at any rates.
inline constexpr MrtRates kQuasisteadyRates = {1.35, 0.95, 1.0, 1.05, 1.21, 3, -5.5, -0.5};

}  // namespace capstan::testing
