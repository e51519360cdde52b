#pragma once
// The D3Q19 lattice (paper eq. 12): directions, weights, opposites, and the moments of d'Humieres et al.
// 2002.
#include <array>

namespace capstan::d3q19 {

inline constexpr int kQ = 19;

struct Direction {
  int x, y, z;
};

// clang-format off
inline constexpr std::array<Direction, kQ> e = {{
    {0, 0, 0},
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},  {0, 0, 1}, {0, 0, -1},
    {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0},
    {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}}};
// clang-format on

/// Weights of the equilibrium at rest: 1/3, 1/18 (axes), 1/36 (diagonals).
inline constexpr double weight(int q) { return q == 0 ? 1.0 / 3 : q <= 6 ? 1.0 / 18 : 1.0 / 36; }

/// Component c (0, 1, 2 for x, y, z) of the direction q.
inline constexpr int component(int q, int c) { return c == 0 ? e[q].x : c == 1 ? e[q].y : e[q].z; }

/// opposite[q] is the direction -e[q].
inline constexpr std::array<int, kQ> opposite = {0, 2,  1,  4,  3,  6,  5,  10, 9, 8,
                                                 7, 14, 13, 12, 11, 18, 17, 16, 15};

/// Rows of the moment matrix M, in the order of d'Humieres et al. and of the paper's relaxation matrix (eq.
/// 14).
enum Moment {
  m_rho,
  m_e,
  m_eps,
  m_jx,
  m_qx,
  m_jy,
  m_qy,
  m_jz,
  m_qz,
  m_3pxx,
  m_3pixx,
  m_pww,
  m_piww,
  m_pxy,
  m_pyz,
  m_pxz,
  m_x,
  m_y,
  m_z
};

/// M_kq: the polynomial of the moment k at the lattice direction q. The rows of M are orthogonal.
inline constexpr double moment_row(int k, int q) {
  const double x = e[q].x, y = e[q].y, z = e[q].z, r2 = x * x + y * y + z * z;
  switch (k) {
    case m_rho:
      return 1;
    case m_e:
      return 19 * r2 - 30;
    case m_eps:
      return (21 * r2 * r2 - 53 * r2 + 24) / 2;
    case m_jx:
      return x;
    case m_qx:
      return (5 * r2 - 9) * x;
    case m_jy:
      return y;
    case m_qy:
      return (5 * r2 - 9) * y;
    case m_jz:
      return z;
    case m_qz:
      return (5 * r2 - 9) * z;
    case m_3pxx:
      return 3 * x * x - r2;
    case m_3pixx:
      return (3 * r2 - 5) * (3 * x * x - r2);
    case m_pww:
      return y * y - z * z;
    case m_piww:
      return (3 * r2 - 5) * (y * y - z * z);
    case m_pxy:
      return x * y;
    case m_pyz:
      return y * z;
    case m_pxz:
      return x * z;
    case m_x:
      return (y * y - z * z) * x;
    case m_y:
      return (z * z - x * x) * y;
    default:
      return (x * x - y * y) * z;
  }
}

/// |M_k|^2, the squared norm of a row of M.
inline constexpr double moment_norm2(int k) {
  double sum = 0;
  for (int q = 0; q < kQ; ++q) sum += moment_row(k, q) * moment_row(k, q);
  return sum;
}

}  // namespace capstan::d3q19
