#pragma once
// Accuracy against speed: the numerical settings of one run, and named presets of them.
#include <string_view>
#include <vector>

#include "solver/case/words.hpp"

namespace capstan {

/// Numerical scheme of the quasisteady lattice flow.
enum class Scheme {
  tuned,  ///< a fine grid around the capsule only, free parameters chosen for convergence; stops on an
          ///< estimate of the error
  paper,  ///< lattice viscosity 0.04, rates 1.8, gamma 0.8, stops on the change of velocity (eq. 26)
};
template <>
inline constexpr auto kWords<Scheme> = std::to_array<Word<Scheme>>({{Scheme::tuned, "tuned"},
                                                                    {Scheme::paper, "paper"}});

/// Time integration of the membrane.
enum class Stepper {
  adams_bashforth,        ///< second order, equal steps, one flow a step (paper eq. 38)
  runge_kutta_chebyshev,  ///< second order, adaptive steps, as many flows a step as stability requires
};
template <>
inline constexpr auto kWords<Stepper> = std::to_array<Word<Stepper>>(
    {{Stepper::adams_bashforth, "ab2"}, {Stepper::runge_kutta_chebyshev, "rkc2"}});

/// Whether the flow of a capsule that starts in the plane of shear is solved for in a quarter of space only.
enum class Symmetry { automatic, none };
template <>
inline constexpr auto kWords<Symmetry> = std::to_array<Word<Symmetry>>({{Symmetry::automatic, "auto"},
                                                                        {Symmetry::none, "none"}});

/// Precision of the numbers on the composite grid and on the transient lattice; forces, positions and
/// observables are always in double precision.
enum class Precision { single, double_ };
template <>
inline constexpr auto kWords<Precision> = std::to_array<Word<Precision>>({{Precision::single, "float"},
                                                                          {Precision::double_, "double"}});

struct Fidelity {
  double error = 0;   ///< largest error of Q = D_xy (cos 2 theta, sin 2 theta) that the run may have: it then
                      ///< climbs the ladder of resolutions (ladder.hpp); 0: a run with the settings below
  double dx = 0.1;    ///< lattice spacing / a
  double box = 25.6;  ///< edge of the cubic domain / a
  int nodes = 2562;   ///< membrane vertices: one of kIcosphereNodes
  Stepper stepper = Stepper::adams_bashforth;
  double kdt = 0.02;        ///< time step k*dt of the membrane; 0 where the stepper chooses
  double tolerance = 1e-4;  ///< relative error of the membrane velocity (scheme tuned) or eq. 26 (paper)
  Scheme scheme = Scheme::tuned;
  Symmetry symmetry = Symmetry::automatic;
  Precision precision = Precision::single;
  bool operator==(const Fidelity&) const = default;
};

/// Tolerance of the flow on a lattice of the tuned scheme. On coarse ones 2e-3 takes up to 40 % fewer cycles
/// than 1e-3 and changes Q by a tenth of what the spacing does. On fine ones rkc2 would shorten its steps.
constexpr double usual_tolerance(double dx) { return dx > 0.15 ? 2e-3 : 1e-3; }

/// Named settings. Stepper and `kdt` are chosen afterwards, for the case (time_step_defaults.hpp).
struct FidelityPreset {
  std::string_view name;
  std::string_view purpose;
  Fidelity settings;
};
const std::vector<FidelityPreset>& fidelity_presets();
std::vector<std::string_view> preset_names();
const FidelityPreset* find_preset(std::string_view name);

/// Vertex counts of the icosahedron whose edges are divided into 1, 2, 3, 4, 6, 8, 12 ... parts
/// (icosphere.hpp).
inline constexpr int kIcosphereNodes[] = {12, 42, 92, 162, 362, 642, 1442, 2562, 5762, 10242, 23042, 40962};

}  // namespace capstan
