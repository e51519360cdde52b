#include "solver/coupling/membrane_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace capstan {
namespace {

/// 1 + cos: of integral 1.
struct Bump {
  double centre, width;  ///< in cells
  double operator()(double z) const {
    const double s = (z - centre) / width;
    return std::abs(s) < 0.5 ? 2 / width * std::pow(std::cos(std::numbers::pi * s), 2) : 0;
  }
};

constexpr double kHalfWidth = 0.6, kShift = 0.1;  // of the jump, in cells
constexpr Bump kViscousBump{-0.5, 1.3}, kFluidBump{1, 2};
/// Both excesses grow as exp(kGrowth kappa z).
constexpr double kGrowth = 2;

struct Layer {
  double V, viscosity, fluidity, slip, C, tension;
};

// From studies/flat_membrane/results.md. At V = 1 the excesses have no effect, and are those of V = 1.5.
constexpr Layer kLayers[] = {{1, 0.0948, 0.1920, 0, 0.1279, 0},
                             {1.5, 0.0948, 0.1920, -0.0360, 0.0966, -0.0052},
                             {2, 0.1200, 0.2089, -0.0579, 0.0774, -0.0086},
                             {3, 0.1609, 0.2305, -0.0843, 0.0548, -0.0130},
                             {4, 0.1923, 0.2445, -0.1001, 0.0416, -0.0156},
                             {5, 0.2175, 0.2548, -0.1106, 0.0328, -0.0173},
                             {7, 0.2555, 0.2697, -0.1237, 0.0218, -0.0195},
                             {10, 0.2949, 0.2849, -0.1339, 0.0126, -0.0214},
                             {20, 0.3654, 0.3133, -0.1439, 0.0008, -0.0238},
                             {50, 0.4431, 0.3477, -0.1426, -0.0069, -0.0255}};

/// The constants are interpolated in this number, which is 0 for V = 1 and tends to 1.
double contrast(double V) { return (V - 1) / (V + 1); }

/// \param V  at least 1
Layer layer_at(double V) {
  const Layer* upper = std::ranges::find_if(kLayers, [V](const Layer& layer) { return layer.V > V; });
  if (upper == std::end(kLayers)) {
    Layer last = *std::prev(upper);
    last.V = V;
    return last;
  }
  const Layer &a = *std::prev(upper), &b = *upper;
  const double weight = (contrast(V) - contrast(a.V)) / (contrast(b.V) - contrast(a.V));
  const auto between = [&](double Layer::*number) { return std::lerp(a.*number, b.*number, weight); };
  return {V,
          between(&Layer::viscosity),
          between(&Layer::fluidity),
          between(&Layer::slip),
          between(&Layer::C),
          between(&Layer::tension)};
}

double viscosity_at(double z, double curvature, const Layer& layer) {
  if (std::abs(z) >= kLayerReach) return z > 0 ? 1 : layer.V;
  const double V = layer.V, growth = std::exp(kGrowth * curvature * z);
  const double viscous = std::pow(V, 1 - smoothed_heaviside(z - kShift, kHalfWidth)) +
                         layer.viscosity * (V - 1) * growth * kViscousBump(z);
  return 1 / (1 / viscous + layer.fluidity * (1 - 1 / V) * growth * kFluidBump(z));
}

/// (sin(k/2) / (k/2))^4
double spline_transform(double k) {
  const double s = k == 0 ? 1 : std::sin(k / 2) / (k / 2);
  return s * s * s * s;
}

/// int p_0^2 dz, in the mean over the directions of n by Lebedev's rule with 26 points. As a function of z
/// the kernel is an integral over a plane; its transform is that of the three-dimensional kernel at k n.
double mean_psi() {
  const struct {
    double weight;
    std::array<double, 3> n;
  } directions[] = {{2. / 7, {1, 0, 0}},
                    {16. / 35, {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2, 0}},
                    {9. / 35, {std::numbers::inv_sqrt3, std::numbers::inv_sqrt3, std::numbers::inv_sqrt3}}};
  constexpr double kStep = 0.05, kMaxWave = 40;  // an error below 1e-4
  double psi = 0;
  for (const auto& [weight, n] : directions)
    for (double k = kStep / 2; k < kMaxWave; k += kStep) {
      const double p = spline_transform(k * n[0]) * spline_transform(k * n[1]) * spline_transform(k * n[2]);
      psi += weight * kStep / std::numbers::pi * p * p;
    }
  return psi;
}

}  // namespace

ViscosityProfile layer_viscosity(double V) {
  if (V >= 1)
    return [layer = layer_at(V)](double z, double curvature) { return viscosity_at(z, curvature, layer); };
  return [V, layer = layer_at(1 / V)](double z, double curvature) {
    return std::abs(z) < kLayerReach ? V * viscosity_at(-z, -curvature, layer) : z > 0 ? 1 : V;
  };
}

LayerCorrections layer_corrections(double V) {
  const Layer layer = layer_at(std::max(V, 1 / V));
  const double kink = std::max(0., layer.C) / mean_psi();
  if (V >= 1) return {layer.slip, layer.tension, kink};
  return {-layer.slip, -layer.tension, kink / V};
}

}  // namespace capstan
