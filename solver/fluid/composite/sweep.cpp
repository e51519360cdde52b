#include "solver/fluid/composite/sweep.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/coupling/vector_units.hpp"
#include "solver/fluid/lattice/d3q19.hpp"

namespace capstan {
namespace {

constexpr int kBlock =
    126;  // cells of a row at a time: with their neighbours 128, and what they send fits into the cache
constexpr int kLanes = 16;  // of the widest registers: loops over whole registers need no remainder

/// 36 times what the cells of a block, x = -1 ... count, send along x: to the right, to the left, and to the
/// same x.
template <class T>
struct Sent {
  T right[3][kBlock + 2], left[3][kBlock + 2], across[3][kBlock + 2];
};
enum { kSentRho, kSentGy, kSentGz };

/// First half of (b): sums over the rows around, cell by cell. Sources y -+ 1 stand for e_y = +-1, likewise
/// z. The sums of what goes to the right serve rho and g_x alike. 36 w_i is 12, 2 along an axis, 1 along a
/// diagonal.
template <class T>
[[gnu::always_inline]] inline void gather(const T* __restrict m, const Strides& s, int count, Sent<T>& sent) {
  const T *rho = m - 1, *gx = rho + s.component, *gy = gx + s.component, *gz = gy + s.component;
  const int padded = (count + 2 + kLanes - 1) & ~(kLanes - 1);  // rows are padded, too
  for (int i = 0; i < padded; ++i) {
    const auto at = [i](const T* field, std::ptrdiff_t offset) { return field[i + offset]; };
    const T rho_y = at(rho, -s.y) + at(rho, s.y), rho_dy = at(rho, -s.y) - at(rho, s.y);
    const T rho_z = at(rho, -s.z) + at(rho, s.z), rho_dz = at(rho, -s.z) - at(rho, s.z);
    const T gx_y = at(gx, -s.y) + at(gx, s.y), gx_dy = at(gx, -s.y) - at(gx, s.y);
    const T gx_z = at(gx, -s.z) + at(gx, s.z), gx_dz = at(gx, -s.z) - at(gx, s.z);
    const T gy_y = at(gy, -s.y) + at(gy, s.y), gy_dy = at(gy, -s.y) - at(gy, s.y);
    const T gz_z = at(gz, -s.z) + at(gz, s.z), gz_dz = at(gz, -s.z) - at(gz, s.z);

    const T even = 2 * rho[i] + (rho_y + rho_z) + 3 * (gy_dy + gz_dz), odd = 2 * gx[i] + (gx_y + gx_z);
    const T even_y = rho_dy + 3 * gy_y, even_z = rho_dz + 3 * gz_z;
    sent.right[kSentRho][i] = even + 3 * odd;
    sent.left[kSentRho][i] = even - 3 * odd;
    sent.right[kSentGy][i] = even_y + 3 * gx_dy;
    sent.left[kSentGy][i] = even_y - 3 * gx_dy;
    sent.right[kSentGz][i] = even_z + 3 * gx_dz;
    sent.left[kSentGz][i] = even_z - 3 * gx_dz;

    // e_x = 0: the axes have twice the diagonals' weight, so they are twice the sums above (and 12 = 8 + 2 *
    // 2)
    const auto phi = [&](int ey, int ez) {
      const std::ptrdiff_t from = -ey * s.y - ez * s.z;
      return at(rho, from) + 3 * (T(ey) * at(gy, from) + T(ez) * at(gz, from));
    };
    const T pp = phi(1, 1), pn = phi(1, -1), np = phi(-1, 1), nn = phi(-1, -1);
    sent.across[kSentRho][i] = 8 * rho[i] + 2 * even + ((pp + pn) + (np + nn));
    sent.across[kSentGy][i] = 2 * even_y + ((pp + pn) - (np + nn));
    sent.across[kSentGz][i] = 2 * even_z + ((pp - pn) + (np - nn));
  }
}

/// Second half of (b): what arrives from the left and the right, and the relaxation.
template <class T>
[[gnu::always_inline]] inline void relax(const FluidRow<T>& row, int first, int count, const Sent<T>& sent) {
  const std::ptrdiff_t k = row.strides.component;
  const T* __restrict m = row.m + first;
  const T* __restrict d = row.defect + first;
  T* __restrict out = row.out + first;
  const T keep = row.keep, blend = row.blend, blend_sent = row.blend / 36;
#pragma GCC ivdep  // a sweep writes other memory than it reads
  for (int i = 0; i < count; ++i) {
    const T from_left = sent.right[kSentRho][i], from_right = sent.left[kSentRho][i + 2];
    const T rho = sent.across[kSentRho][i + 1] + (from_left + from_right);
    const T gx = from_left - from_right;
    const T gy = sent.across[kSentGy][i + 1] + (sent.right[kSentGy][i] + sent.left[kSentGy][i + 2]);
    const T gz = sent.across[kSentGz][i + 1] + (sent.right[kSentGz][i] + sent.left[kSentGz][i + 2]);
    out[i] = keep * m[i] + blend_sent * rho + blend * d[i];
    out[i + k] = keep * m[i + k] + blend_sent * gx + blend * d[i + k];
    out[i + 2 * k] = keep * m[i + 2 * k] + blend_sent * gy + blend * d[i + 2 * k];
    out[i + 3 * k] = keep * m[i + 3 * k] + blend_sent * gz + blend * d[i + 3 * k];
  }
}

template <class T>
[[gnu::always_inline]] inline void sweep_fluid_row(const FluidRow<T>& row) {
  alignas(64) Sent<T> sent;
  for (int first = 0; first < row.count; first += kBlock) {
    const int count = std::min(kBlock, row.count - first);
    gather(row.m + first, row.strides, count, sent);
    relax(row, first, count, sent);
  }
}

template <class T>
struct Arrived {
  T rho = 0, gx = 0, gy = 0, gz = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

/// (a) and (b) for one direction; what is multiplied with a component of e that is 0 falls out when this is
/// compiled.
template <int q, class T>
[[gnu::always_inline]] inline void arrive(const T* __restrict m, const Strides& s, const T* __restrict Q,
                                          const Strides& t, int i, Arrived<T>& sum) {
  constexpr int ex = d3q19::e[q].x, ey = d3q19::e[q].y, ez = d3q19::e[q].z;
  constexpr T w = T(d3q19::weight(q));
  const std::ptrdiff_t at = i - ex - ey * s.y - ez * s.z, stress_at = i - ex - ey * t.y - ez * t.z;
  T phi = m[at + kRho * s.component];
  if constexpr (ex != 0) phi += T(3 * ex) * m[at + kGx * s.component];
  if constexpr (ey != 0) phi += T(3 * ey) * m[at + kGy * s.component];
  if constexpr (ez != 0) phi += T(3 * ez) * m[at + kGz * s.component];
  // e_i e_i : Q with Q_zz = -Q_xx - Q_yy
  if constexpr (ex * ex != ez * ez) phi += T(4.5 * (ex * ex - ez * ez)) * Q[stress_at + kXX * t.component];
  if constexpr (ey * ey != ez * ez) phi += T(4.5 * (ey * ey - ez * ez)) * Q[stress_at + kYY * t.component];
  if constexpr (ex * ey != 0) phi += T(9 * ex * ey) * Q[stress_at + kXY * t.component];
  if constexpr (ex * ez != 0) phi += T(9 * ex * ez) * Q[stress_at + kXZ * t.component];
  if constexpr (ey * ez != 0) phi += T(9 * ey * ez) * Q[stress_at + kYZ * t.component];
  const T f = w * phi;
  sum.rho += f;
  if constexpr (ex != 0) sum.gx += T(ex) * f, sum.xx += f;
  if constexpr (ey != 0) sum.gy += T(ey) * f, sum.yy += f;
  if constexpr (ez != 0) sum.gz += T(ez) * f, sum.zz += f;
  if constexpr (ex * ey != 0) sum.xy += T(ex * ey) * f;
  if constexpr (ex * ez != 0) sum.xz += T(ex * ez) * f;
  if constexpr (ey * ez != 0) sum.yz += T(ey * ez) * f;
}

template <class T, std::size_t... q>
[[gnu::always_inline]] inline void sweep_stress_row(const StressRow<T>& row, std::index_sequence<q...>) {
  const FluidRow<T> fluid = row.fluid;
  const Strides s = fluid.strides, t = row.stress_strides;
  const T* __restrict p = row.p;
  const T* __restrict p_defect = row.p_defect;
  T* __restrict out = fluid.out;
  T* __restrict p_out = row.p_out;
  const T keep = fluid.keep, blend = fluid.blend, p_keep = row.p_keep, p_blend = row.p_blend;
#pragma GCC ivdep
  for (int i = 0; i < fluid.count; ++i) {
    Arrived<T> sum;
    (arrive<int(q)>(fluid.m, s, row.q, t, i, sum), ...);
    const T trace = (sum.xx + sum.yy + sum.zz) / 3;
    const auto relax = [&](int k, T arrived) {
      const std::ptrdiff_t at = i + k * s.component;
      out[at] = keep * fluid.m[at] + blend * (arrived + fluid.defect[at]);
    };
    const auto relax_stress = [&](int k, T arrived) {
      const std::ptrdiff_t at = i + k * t.component;
      p_out[at] = p_keep * p[at] + p_blend * (arrived + p_defect[at]);
    };
    relax(kRho, sum.rho), relax(kGx, sum.gx), relax(kGy, sum.gy), relax(kGz, sum.gz);
    relax_stress(kXX, sum.xx - trace), relax_stress(kYY, sum.yy - trace);
    relax_stress(kXY, sum.xy), relax_stress(kXZ, sum.xz), relax_stress(kYZ, sum.yz);
  }
}

}  // namespace

CAPSTAN_VECTOR_UNITS void sweep_fluid(const FluidRow<float>& row) { sweep_fluid_row(row); }
CAPSTAN_VECTOR_UNITS void sweep_fluid(const FluidRow<double>& row) { sweep_fluid_row(row); }

CAPSTAN_VECTOR_UNITS void sweep_stress(const StressRow<float>& row) {
  sweep_stress_row(row, std::make_index_sequence<d3q19::kQ>());
}
CAPSTAN_VECTOR_UNITS void sweep_stress(const StressRow<double>& row) {
  sweep_stress_row(row, std::make_index_sequence<d3q19::kQ>());
}

}  // namespace capstan
