#include "solver/coupling/membrane_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/coupling/sharpening.hpp"
#include "solver/coupling/viscosity_field.hpp"

namespace capstan {
namespace {

constexpr int kOffsets = 8;                        // positions of the membrane between two planes
constexpr double kReach = 8;                       // beyond this distance kernels and jump are over
constexpr double kWaveStep = 0.05, kMaxWave = 40;  // an error below 1e-3 in every sum

/// (sin(k/2) / (k/2))^4
double spline_transform(double k) {
  const double s = k == 0 ? 1 : std::sin(k / 2) / (k / 2);
  return s * s * s * s;
}

/// A plane of cells across the normal.
struct Plane {
  double z;
  double plain = 0, sharp = 0, slope = 0;  ///< p_0, p and p' at z
};

/// The planes around a membrane at z = 0. The kernels as functions of z are integrals over the plane; their
/// transforms are those of the three-dimensional kernels at k n.
std::vector<Plane> planes_along(const Vec3& normal, double spacing, double offset) {
  std::vector<Plane> planes;
  for (double z = offset - std::ceil(kReach / spacing) * spacing; z < kReach; z += spacing)
    planes.push_back({.z = z});
  for (double k = 0; k < kMaxWave; k += kWaveStep) {
    const Vec3 wave = k * normal;
    const double transform = (k == 0 ? 0.5 : 1) * kWaveStep / std::numbers::pi * spline_transform(wave[0]) *
                             spline_transform(wave[1]) * spline_transform(wave[2]);
    const double sharp = transform * sharpening_symbol(wave[0], wave[1], wave[2]);
    for (Plane& plane : planes) {
      const double c = std::cos(k * plane.z);
      plane.plain += transform * c;
      plane.sharp += sharp * c;
      plane.slope -= sharp * k * std::sin(k * plane.z);
    }
  }
  return planes;
}

struct Direction {
  double weight;   ///< in Lebedev's rule
  double spacing;  ///< of the planes
  std::array<std::vector<Plane>, kOffsets> planes;

  Direction(double weight_, const Vec3& normal, double spacing_) : weight(weight_), spacing(spacing_) {
    for (int n = 0; n < kOffsets; ++n)
      planes[n] = planes_along(normal, spacing, (n + 0.5) / kOffsets * spacing);
  }
};
const std::array<Direction, 3>& directions() {
  static const std::array<Direction, 3> all = {
      Direction(2. / 7, Vec3(1, 0, 0), 1), Direction(16. / 35, Vec3(1, 1, 0).normalized(), std::sqrt(0.5)),
      Direction(9. / 35, Vec3(1, 1, 1).normalized(), std::sqrt(1. / 3))};
  return all;
}

/// Of a membrane with f = 1 that is at rest in the sharp solution, for tau = 0.
struct LayerErrors {
  double slip = 0;  ///< velocity that is too large on the outer side, if it is right on the inner side
  double read = 0;  ///< velocity that is read
};

LayerErrors errors_at(const std::vector<Plane>& planes, double h, double V, double s) {
  const auto a = [V](double z) { return (1 - 1 / V) * (1 - smoothed_heaviside(z, kViscosityHalfWidth)); };
  const auto weight = [s](const Plane& plane) { return plane.sharp - s * plane.slope; };
  const auto force = [&](const Plane& plane) { return weight(plane) / 6; };
  double tau = 1 / (12 * h);              // 1/2 in units of the lattice
  double g = planes.front().z / (2 * V);  // the sharp solution
  LayerErrors errors;
  for (std::size_t j = 0; j < planes.size(); ++j) {
    if (j > 0) {
      const Plane &last = planes[j - 1], &now = planes[j];
      tau -= force(last);
      g += 6 * h * h * tau * (1 - (a(last.z) + a(now.z)) / 2) -
           1.5 * h * h * (a(last.z) * force(last) - a(now.z) * force(now));
    }
    errors.read += h * weight(planes[j]) * (g - force(planes[j]) / 2);
  }
  errors.slip = g + planes.back().z / 2;
  return errors;
}

LayerErrors errors_along(const Direction& direction, double V, double s) {
  LayerErrors mean;
  for (const std::vector<Plane>& planes : direction.planes) {
    const LayerErrors one = errors_at(planes, direction.spacing, V, s);
    mean.slip += one.slip / kOffsets, mean.read += one.read / kOffsets;
  }
  return mean;
}

LayerErrors mean_errors(double V, double s) {
  LayerErrors mean;
  for (const Direction& direction : directions()) {
    const LayerErrors one = errors_along(direction, V, s);
    mean.slip += direction.weight * one.slip, mean.read += direction.weight * one.read;
  }
  return mean;
}

/// int p_0^2 dz
double mean_psi() {
  double psi = 0;
  for (const Direction& direction : directions())
    for (const std::vector<Plane>& planes : direction.planes)
      for (const Plane& plane : planes)
        psi += direction.weight / kOffsets * direction.spacing * plane.plain * plane.plain;
  return psi;
}

}  // namespace

// The slip of the fluid is linear in s.
LayerCorrections layer_corrections(double V) {
  const double without = mean_errors(V, 0).slip, with = mean_errors(V, 1).slip;
  const double slip = V == 1 ? 0 : without / (without - with);
  return {slip, std::max(0., -mean_errors(V, slip).read) / mean_psi()};
}

double kink_along(int direction) { return -errors_along(directions()[std::size_t(direction)], 1, 0).read; }

}  // namespace capstan
