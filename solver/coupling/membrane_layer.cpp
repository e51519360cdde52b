#include "solver/coupling/membrane_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace capstan {
namespace {

constexpr double kHalfWidth = 0.5, kShift = -0.3;  // of the jump, in cells

struct Layer {
  double V, excess, slip, C, tension;
};

// From studies/flat_membrane/results.md. At V = 1 the excess has no effect, and is that of V = 1.5.
constexpr Layer kLayers[] = {{1, 0.4270, 0, 0.1279, 0},
                             {1.5, 0.4270, -0.0495, 0.1072, -0.0067},
                             {2, 0.5256, -0.0858, 0.0911, -0.0114},
                             {3, 0.6644, -0.1360, 0.0676, -0.0173},
                             {4, 0.7557, -0.1691, 0.0516, -0.0207},
                             {5, 0.8202, -0.1925, 0.0401, -0.0229},
                             {7, 0.9057, -0.2236, 0.0248, -0.0255},
                             {10, 0.9811, -0.2511, 0.0113, -0.0276},
                             {20, 1.0903, -0.2908, -0.0077, -0.0301},
                             {50, 1.1818, -0.3237, -0.0223, -0.0318}};

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
  return {V, between(&Layer::excess), between(&Layer::slip), between(&Layer::C), between(&Layer::tension)};
}

double viscosity_at(double z, const Layer& layer) {
  if (std::abs(z) >= kLayerReach) return z > 0 ? 1 : layer.V;
  const double H = smoothed_heaviside(z - kShift, kHalfWidth);
  const double next_to_membrane = z > -1 && z < 0 ? 2 * std::pow(std::sin(std::numbers::pi * z), 2) : 0;
  return 1 / (H + (1 - H) / layer.V) + layer.excess * (layer.V - 1) * next_to_membrane;
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
  if (V >= 1) return [layer = layer_at(V)](double z) { return viscosity_at(z, layer); };
  return [V, layer = layer_at(1 / V)](double z) {
    return std::abs(z) < kLayerReach ? V * viscosity_at(-z, layer) : z > 0 ? 1 : V;
  };
}

LayerCorrections layer_corrections(double V) {
  const Layer layer = layer_at(std::max(V, 1 / V));
  const double kink = std::max(0., layer.C) / mean_psi();
  if (V >= 1) return {layer.slip, layer.tension, kink};
  return {-layer.slip, -layer.tension, kink / V};
}

}  // namespace capstan
