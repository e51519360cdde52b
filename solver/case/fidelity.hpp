#pragma once
// Accuracy against speed: the numerical settings of one run, as named presets and single knobs.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// How the quasi-steady lattice flow is solved.
enum class Scheme {
  tuned,  ///< a fine grid around the capsule only, free parameters chosen for convergence; stops on an
          ///< estimate of the error
  paper,  ///< lattice viscosity 0.04, rates 1.8, gamma 0.8, stops on the change of velocity (eq. 26)
};

/// How the membrane moves with the flow.
enum class Stepper {
  adams_bashforth,        ///< "ab2": second order, equal steps, one flow a step (paper eq. 38)
  runge_kutta_chebyshev,  ///< "rkc2": second order, steps after their error, as many flows as stability asks
                          ///< for
};

/// Whether the symmetry of a capsule that starts in the plane of shear is made use of: a quarter of the flow
/// is solved for.
enum class Symmetry { automatic, none };

/// Of the numbers on the grids of the scheme tuned and of the transient lattice; forces, positions and
/// observables are always double.
enum class Precision { single, double_ };

struct Fidelity {
  double dx = 0.1;    ///< lattice spacing / a
  double box = 12.8;  ///< edge of the cubic domain / a
  int nodes = 2562;   ///< membrane vertices: 10 * 4^n + 2
  Stepper stepper = Stepper::adams_bashforth;
  double kdt = 0.02;        ///< time step k*dt of the membrane; 0 where the stepper chooses
  double tolerance = 1e-4;  ///< relative error of the membrane velocity (scheme tuned) or eq. 26 (paper)
  Scheme scheme = Scheme::tuned;
  Symmetry symmetry = Symmetry::automatic;
  Precision precision = Precision::single;
  bool operator==(const Fidelity&) const = default;
};

/// A named preset; stepper and `kdt` are still to be chosen (time_step_defaults.hpp).
struct FidelityPreset {
  std::string_view name;
  std::string_view purpose;
  Fidelity knobs;
};
const std::vector<FidelityPreset>& fidelity_presets();
const FidelityPreset* find_preset(std::string_view name);

/// Vertex counts of the subdivided icosahedron: 12, 42, 162, 642, 2562, 10242, 40962.
std::optional<int> icosphere_subdivisions(int nodes);

std::string_view to_string(Scheme scheme);
std::string_view to_string(Stepper stepper);
std::string_view to_string(Symmetry symmetry);
std::string_view to_string(Precision precision);

}  // namespace capstan
