#pragma once
// Length and number of stages of a step of the Runge-Kutta-Chebyshev method
// (solver/simulation/runge_kutta_chebyshev.hpp). Both follow from the rate at which the fastest mode of the
// membrane decays, in units of k: the spectral radius of dU/dX.
#include <algorithm>
#include <cmath>

namespace capstan {

inline constexpr double kRkc2Step = 0.1;      ///< k dt, the largest step of a stiff membrane
inline constexpr double kRkc2SoftStep = 0.2;  ///< that of a soft one, if it is longer
inline constexpr double kRkc2Safety = 1.2;    ///< on an estimate of the spectral radius from below

/// The longest accurate step. The error estimate does not see the phase of a tumbling capsule, so that steps
/// are bounded, too. Measured on red cells, V = 4, with 642 nodes to kt = 30: steps of 0.2 change Q by at
/// most 0.001 at Ca = 0.25 and 0.6, where the spectral radius is 40 and 20, but by 0.006 to 0.009 at
/// Ca = 0.1, 0.05 and 0.016, where it is 90 to 600. Steps of 0.1 change Q by 0.002 there.
inline double longest_rkc2_step(double spectral_radius, double step = kRkc2Step,
                                double soft_step = kRkc2SoftStep) {
  constexpr double kDecayInSoftStep = 11;
  return std::max(step, std::min(soft_step, kDecayInSoftStep / spectral_radius));
}

/// The number of stages s with which a step is stable: the stability limit is
///   beta(s) = (2/3)(s^2 - 1)(1 - 2 epsilon / 15) >= step * spectral radius.
inline int rkc2_stages(double step, double spectral_radius) {
  constexpr double kMost = 1e6;  // a membrane may be stiff without limit
  return std::max(2, 1 + int(std::min(kMost, std::sqrt(1 + 1.54 * step * spectral_radius))));
}

}  // namespace capstan
