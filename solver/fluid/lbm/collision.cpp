#include "solver/fluid/lbm/collision.hpp"

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

/// -s_k / |M_k|^2 for each relaxed moment k except the stress: the factors in d_k below.
template <class Real>
struct Factors {
  Factors(const MrtRates& r, double products_of_momentum)
      : e(Real(-r.e / 126)),
        eps(Real(-r.eps / 252)),
        q(Real(-r.q / 40)),
        pi3xx(Real(-r.pi / 72)),
        piww(Real(-r.pi / 24)),
        m(Real(-r.m / 8)),
        w_eps(Real(r.w_eps)),
        w_eps_j(Real(r.w_eps_j)),
        w_xx(Real(r.w_xx)),
        inertia(Real(products_of_momentum)) {}
  Real e, eps, q, pi3xx, piww, m, w_eps, w_eps_j, w_xx, inertia;
};

// The change of the moment k by the collision, over the squared norm of its row of M, is
//   d_k = -s_k (m_k - m_k_eq) / |M_k|^2,   and   f* = f + M^T d.
// Even moments (of x, y, z) need only the sums of opposite populations, odd ones only their differences.
// Within these, moments such as p_xx and pi_xx, or j and q, combine the same sums over axes and diagonals. So
// a cell takes about 230 additions and multiplications, instead of 1444 for products with M and its inverse.
// Written without loops over moments, a loop over the cells of a row vectorises.
template <class Real>
[[gnu::always_inline]] inline void collide_cell(const CollisionRow<Real>& c, const Factors<Real>& r,
                                                std::size_t i) {
  constexpr Real kTwoThirds = Real(2.0 / 3), kTenth = Real(0.1), kHalf = Real(0.5);
  constexpr Real kPerNorm3pxx = Real(-1.0 / 36), kPerNormPww = Real(-1.0 / 12), kPerNormPxy = Real(-0.25);
  Real f[d3q19::kQ];
#pragma GCC unroll 19
  for (int q = 0; q < d3q19::kQ; ++q) f[q] = c.f[q][i];

  // sums of opposite populations
  const Real sx = f[1] + f[2], sy = f[3] + f[4], sz = f[5] + f[6];
  const Real pxy = f[7] + f[10], nxy = f[8] + f[9], dxy = pxy + nxy;
  const Real pxz = f[11] + f[14], nxz = f[13] + f[12], dxz = pxz + nxz;
  const Real pyz = f[15] + f[18], nyz = f[17] + f[16], dyz = pyz + nyz;
  const Real sy_sz = sy + sz, dxy_dxz = dxy + dxz;
  const Real axes = sx + sy_sz, diagonals = dxy_dxz + dyz;
  // differences
  const Real ax = f[1] - f[2], ay = f[3] - f[4], az = f[5] - f[6];
  const Real bxy = f[7] - f[10], cxy = f[8] - f[9];
  const Real bxz = f[11] - f[14], cxz = f[13] - f[12];
  const Real byz = f[15] - f[18], cyz = f[17] - f[16];
  const Real x_in_xy = bxy + cxy, y_in_xy = bxy - cxy;
  const Real x_in_xz = bxz + cxz, z_in_xz = bxz - cxz;
  const Real y_in_yz = byz + cyz, z_in_yz = byz - cyz;
  const Real bx = x_in_xy + x_in_xz, by = y_in_xy + y_in_yz, bz = z_in_xz + z_in_yz;

  // eq. 18: the velocity in the equilibrium includes half of the force
  const Real rho = f[0] + axes + diagonals;
  const Real Fx = c.force[0][i], Fy = c.force[1][i], Fz = c.force[2][i];
  const Real ux = ax + bx + kHalf * Fx, uy = ay + by + kHalf * Fy, uz = az + bz + kHalf * Fz;
  const Real jx = r.inertia * ux, jy = r.inertia * uy, jz = r.inertia * uz;
  const Real uxx = jx * ux, uyy = jy * uy, uzz = jz * uz;
  const Real uu = uxx + uyy + uzz;
  const Real p3xx_eq = 3 * uxx - uu, pww_eq = uyy - uzz;

  // even moments; e - e_eq = 19 (diagonals - f_0 - inertia u^2), and |M_e|^2 = 19 * 126
  const Real axes_xx = 2 * sx - sy_sz, diagonals_xx = dxy_dxz - 2 * dyz;
  const Real axes_ww = sy - sz, diagonals_ww = dxy - dxz;
  const Real s_nu = c.s_nu[i];
  const Real d_e = r.e * (diagonals - f[0] - uu);
  const Real d_eps = r.eps * (12 * f[0] - 4 * axes + diagonals - r.w_eps * rho - r.w_eps_j * uu);
  const Real d_p3xx = kPerNorm3pxx * s_nu * (axes_xx + diagonals_xx - p3xx_eq);
  const Real d_pi3xx = r.pi3xx * (diagonals_xx - 2 * axes_xx - r.w_xx * p3xx_eq);
  const Real d_pww = kPerNormPww * s_nu * (axes_ww + diagonals_ww - pww_eq);
  const Real d_piww = r.piww * (diagonals_ww - 2 * axes_ww - r.w_xx * pww_eq);
  const Real s_xy = kPerNormPxy * s_nu;
  const Real d_pxy = s_xy * (pxy - nxy - jx * uy);
  const Real d_pxz = s_xy * (pxz - nxz - jx * uz);
  const Real d_pyz = s_xy * (pyz - nyz - jy * uz);

  // odd moments; eqs. 18 and 19: the collision adds the whole force to the momentum
  const Real d_qx = r.q * (bx - 4 * ax + kTwoThirds * ux);
  const Real d_qy = r.q * (by - 4 * ay + kTwoThirds * uy);
  const Real d_qz = r.q * (bz - 4 * az + kTwoThirds * uz);
  const Real d_mx = r.m * (x_in_xy - x_in_xz);
  const Real d_my = r.m * (y_in_yz - y_in_xy);
  const Real d_mz = r.m * (z_in_xz - z_in_yz);
  const Real d_jx = kTenth * Fx, d_jy = kTenth * Fy, d_jz = kTenth * Fz;

  // back to populations: f* = f + M^T d
  c.f_star[0][i] = f[0] - 30 * d_e + 12 * d_eps;
  const Real axis = -11 * d_e - 4 * d_eps;
  const Real stretch = d_p3xx - 2 * d_pi3xx, split = d_pww - 2 * d_piww, axis_yz = axis - stretch;
  const Real even_x = axis + 2 * stretch, even_y = axis_yz + split, even_z = axis_yz - split;
  const Real odd_x = d_jx - 4 * d_qx, odd_y = d_jy - 4 * d_qy, odd_z = d_jz - 4 * d_qz;
  c.f_star[1][i] = f[1] + (even_x + odd_x);
  c.f_star[2][i] = f[2] + (even_x - odd_x);
  c.f_star[3][i] = f[3] + (even_y + odd_y);
  c.f_star[4][i] = f[4] + (even_y - odd_y);
  c.f_star[5][i] = f[5] + (even_z + odd_z);
  c.f_star[6][i] = f[6] + (even_z - odd_z);

  const Real diagonal = 8 * d_e + d_eps, across = d_p3xx + d_pi3xx, fan = d_pww + d_piww;
  const Real along_x = diagonal + across, even_xy = along_x + fan, even_xz = along_x - fan;
  const Real even_yz = diagonal - 2 * across;
  const Real kx = d_jx + d_qx, ky = d_jy + d_qy, kz = d_jz + d_qz;
  const Real xy_x = kx + d_mx, xy_y = ky - d_my, xy_p = even_xy + d_pxy, xy_n = even_xy - d_pxy;
  c.f_star[7][i] = f[7] + (xy_p + (xy_x + xy_y));
  c.f_star[10][i] = f[10] + (xy_p - (xy_x + xy_y));
  c.f_star[8][i] = f[8] + (xy_n + (xy_x - xy_y));
  c.f_star[9][i] = f[9] + (xy_n - (xy_x - xy_y));
  const Real xz_x = kx - d_mx, xz_z = kz + d_mz, xz_p = even_xz + d_pxz, xz_n = even_xz - d_pxz;
  c.f_star[11][i] = f[11] + (xz_p + (xz_x + xz_z));
  c.f_star[14][i] = f[14] + (xz_p - (xz_x + xz_z));
  c.f_star[13][i] = f[13] + (xz_n + (xz_x - xz_z));
  c.f_star[12][i] = f[12] + (xz_n - (xz_x - xz_z));
  const Real yz_y = ky + d_my, yz_z = kz - d_mz, yz_p = even_yz + d_pyz, yz_n = even_yz - d_pyz;
  c.f_star[15][i] = f[15] + (yz_p + (yz_y + yz_z));
  c.f_star[18][i] = f[18] + (yz_p - (yz_y + yz_z));
  c.f_star[17][i] = f[17] + (yz_n + (yz_y - yz_z));
  c.f_star[16][i] = f[16] + (yz_n - (yz_y - yz_z));
}

// Prefetches explicitly, eight cache lines ahead: there are more arrays than the hardware prefetcher can
// track, and a cell takes so many instructions that out-of-order execution starts the loads of only the next
// one or two vectors of cells.
template <class Real>
[[gnu::always_inline]] inline void collide_row(const CollisionRow<Real>& row, const Factors<Real>& factors) {
  constexpr std::size_t kLine = 64 / sizeof(Real), kAhead = 8 * kLine;
  const CollisionRow<Real> c = row;
  const Factors<Real> r = factors;
  std::size_t first = 0;
  for (; first + kLine <= c.count; first += kLine) {
    for (const Real* f : c.f) __builtin_prefetch(f + first + kAhead, 1);
#pragma GCC ivdep
    for (std::size_t i = first; i < first + kLine; ++i) collide_cell(c, r, i);
  }
#pragma GCC ivdep
  for (std::size_t i = first; i < c.count; ++i) collide_cell(c, r, i);
}

}  // namespace

CAPSTAN_VECTOR_UNITS void collide(const CollisionRow<double>& row, const MrtRates& rates, double inertia) {
  collide_row(row, Factors<double>(rates, inertia));
}

CAPSTAN_VECTOR_UNITS void collide(const CollisionRow<float>& row, const MrtRates& rates, double inertia) {
  collide_row(row, Factors<float>(rates, inertia));
}

}  // namespace capstan
