#pragma once
// Relaxation rates for tests.
#include "solver/fluid/lbm/collision.hpp"

namespace capstan::testing {

/// Relaxation rates that all differ, for properties that must hold at any rates.
inline constexpr MrtRates kQuasisteadyRates = {1.35, 0.95, 1.0, 1.05, 1.21, 3, -5.5, -0.5};

}  // namespace capstan::testing
