#pragma once
// A neo-Hookean sphere in unbounded shear flow, V = 1, E_b = 0, Re = 0, by a boundary integral method that
// was converged in its mesh and checked against linear theory (0.2 %). For Ca <= 0.05, where a membrane
// without bending wrinkles, from E_b = 2e-4 and 1e-3 extrapolated to 0. Ca is the paper's (E_s = 3 G).
#include <array>
#include <stdexcept>

namespace capstan::reference {

struct NeoHookeanSphere {
  double Ca;
  double D_xy, theta_over_pi;     ///< steady
  std::array<double, 4> D_xy_at;  ///< at kt = 0.5, 1, 2, 3
};

inline constexpr std::array<double, 4> kTimes = {0.5, 1, 2, 3};

inline const NeoHookeanSphere& neo_hookean_sphere(double Ca) {
  static const std::array<NeoHookeanSphere, 3> all = {{
      {0.0125, 0.0782, 0.226, {0.0745, 0.0776, 0.0778, 0.0778}},
      {0.05, 0.2712, 0.172, {0.1694, 0.2335, 0.2661, 0.2700}},
      {0.1, 0.3973, 0.140, {0.2024, 0.3119, 0.3868, 0.3986}},
  }};
  for (const NeoHookeanSphere& sphere : all)
    if (sphere.Ca == Ca) return sphere;
  throw std::out_of_range("no reference for this Ca");
}

}  // namespace capstan::reference
