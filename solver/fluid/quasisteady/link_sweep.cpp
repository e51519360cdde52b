#include "solver/fluid/quasisteady/link_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "solver/fluid/lbm/d3q19.hpp"
#include "solver/fluid/quasisteady/moment_sweep.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// The directions of the links, each followed by its opposite.
constexpr std::array<int, 18> kLinks = {1, 2, 3, 4, 5, 6, 7, 10, 8, 9, 11, 14, 13, 12, 15, 18, 17, 16};

/// Calls visit(integral_constant<int, q>) for the direction q of each link.
template <class Visit>
[[gnu::always_inline]] inline void for_each_link(Visit visit) {
  [&]<int... n>(std::integer_sequence<int, n...>) __attribute__((always_inline)) {
    (visit(std::integral_constant<int, kLinks[n]>{}), ...);
  }
  (std::make_integer_sequence<int, int(kLinks.size())>{});
}

/// The sums of (b) over the links of a cell, and by what they are divided.
template <class T>
struct Sums {
  T mass = 0, x = 0, y = 0, z = 0;
  T of_density = 0;                   ///< 3/2 R sum w k, which is 1 in uniform fluid
  T of_gx = 0, of_gy = 0, of_gz = 0;  ///< 3 R sum w k R' e_x^2 etc., which are R in uniform fluid
};

template <class T>
[[gnu::always_inline]] inline Sums<T> sums_at(const LinkRow<T>& row, int i) {
  const Strides &s = row.strides, &t = row.ratio_strides;
  const T *rho = row.m, *gx = rho + s.component, *gy = gx + s.component, *gz = gy + s.component;
  const T R = row.ratio[i], density = rho[i], x = gx[i], y = gy[i], z = gz[i];
  Sums<T> sums;
  for_each_link([&](auto q) __attribute__((always_inline)) {
    constexpr d3q19::Direction e = d3q19::e[q];
    const std::ptrdiff_t at = i - e.x - e.y * s.y - e.z * s.z;
    const T other = row.ratio[i - e.x - e.y * t.y - e.z * t.z];
    T approach = 0;  // e.(g' - g)
    if constexpr (e.x != 0) approach += T(e.x) * (gx[at] - x);
    if constexpr (e.y != 0) approach += T(e.y) * (gy[at] - y);
    if constexpr (e.z != 0) approach += T(e.z) * (gz[at] - z);
    if constexpr (e.x * e.y != 0) approach -= T(e.x * e.y) * row.dx;
    const T k = T(2 * d3q19::weight(q)) / (R + other);
    const T sent = k * (other * (rho[at] + 3 * approach) - R * density);
    sums.mass += sent;
    if constexpr (e.x != 0) sums.x += T(e.x) * sent;
    if constexpr (e.y != 0) sums.y += T(e.y) * sent;
    if constexpr (e.z != 0) sums.z += T(e.z) * sent;
    sums.of_density += T(1.5) * k * R;
    const T of_momentum = 3 * k * other;
    if constexpr (e.x != 0) sums.of_gx += of_momentum;
    if constexpr (e.y != 0) sums.of_gy += of_momentum;
    if constexpr (e.z != 0) sums.of_gz += of_momentum;
  });
  sums.x *= R, sums.y *= R, sums.z *= R;
  sums.of_gx *= R, sums.of_gy *= R, sums.of_gz *= R;
  return sums;
}

template <bool kIsResidual, class T>
[[gnu::always_inline]] inline void sweep(const LinkRow<T>& row, T gamma) {
  const std::ptrdiff_t k = row.strides.component;
  const T* __restrict m = row.m;
  const T* __restrict d = row.defect;
  T* __restrict out = row.out;
  const T carried = 2 * std::abs(row.shear) + std::abs(row.lift);
  const auto own_of_momentum = [&](T of_links) { return std::max(of_links, carried) + row.rate; };
#pragma GCC ivdep
  for (int i = 0; i < row.count; ++i) {
    const Sums<T> sums = sums_at(row, i);
    const auto put = [&](int j, T left, T own) {
      const std::ptrdiff_t at = i + j * k;
      out[at] = kIsResidual ? left : m[at] + gamma / own * left;
    };
    const auto left_of_momentum = [&](int j, T sum) {
      const std::ptrdiff_t at = i + j * k;
      return sum + d[at] - row.shear * (m[at + 1] - m[at - 1]) - row.rate * m[at];
    };
    put(kRho, sums.mass + d[i], sums.of_density);
    put(kGx, left_of_momentum(kGx, sums.x) - row.lift * m[i + kGy * k], own_of_momentum(sums.of_gx));
    put(kGy, left_of_momentum(kGy, sums.y), own_of_momentum(sums.of_gy));
    put(kGz, left_of_momentum(kGz, sums.z), own_of_momentum(sums.of_gz));
  }
  for (int j = 0; j < int(kMoments); ++j)
    for (const int end : {-1, row.count}) out[end + j * k] = m[end + j * k];
}

}  // namespace

CAPSTAN_VECTOR_UNITS void relax_links(const LinkRow<float>& row, float gamma) { sweep<false>(row, gamma); }
CAPSTAN_VECTOR_UNITS void relax_links(const LinkRow<double>& row, double gamma) { sweep<false>(row, gamma); }
CAPSTAN_VECTOR_UNITS void put_residual_of_links(const LinkRow<float>& row) { sweep<true>(row, 1.f); }
CAPSTAN_VECTOR_UNITS void put_residual_of_links(const LinkRow<double>& row) { sweep<true>(row, 1.); }

}  // namespace capstan
