#include "solver/fluid/lattice/collision.hpp"

namespace capstan {

// The moments are sums and differences of opposite populations: even moments need the sums, odd ones the
// differences. Written out, the row vectorises over its cells. d_k = -s_k (m_k - m_k_eq) / |M_k|^2.
__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"))) void collide(
    const CollisionRow& row, const MrtRates& rates, double inertia) {
  const CollisionRow c = row;
  const MrtRates r = rates;
  const auto& f = c.f;
  const auto& out = c.f_star;
#pragma GCC ivdep
  for (std::size_t i = 0; i < c.count; ++i) {
    // sums of opposite populations
    const double f0 = f[0][i];
    const double sx = f[1][i] + f[2][i], sy = f[3][i] + f[4][i], sz = f[5][i] + f[6][i];
    const double pxy = f[7][i] + f[10][i], nxy = f[8][i] + f[9][i], dxy = pxy + nxy;
    const double pxz = f[11][i] + f[14][i], nxz = f[13][i] + f[12][i], dxz = pxz + nxz;
    const double pyz = f[15][i] + f[18][i], nyz = f[17][i] + f[16][i], dyz = pyz + nyz;
    const double axes = sx + sy + sz, diagonals = dxy + dxz + dyz;
    // differences
    const double ax = f[1][i] - f[2][i], ay = f[3][i] - f[4][i], az = f[5][i] - f[6][i];
    const double bxy = f[7][i] - f[10][i], cxy = f[8][i] - f[9][i];
    const double bxz = f[11][i] - f[14][i], cxz = f[13][i] - f[12][i];
    const double byz = f[15][i] - f[18][i], cyz = f[17][i] - f[16][i];
    const double x_in_xy = bxy + cxy, y_in_xy = bxy - cxy;
    const double x_in_xz = bxz + cxz, z_in_xz = bxz - cxz;
    const double y_in_yz = byz + cyz, z_in_yz = byz - cyz;

    const double rho = f0 + axes + diagonals;
    const double jx = ax + x_in_xy + x_in_xz, jy = ay + y_in_xy + y_in_yz, jz = az + z_in_xz + z_in_yz;
    // eq. 18: the equilibrium sees half of the force
    const double ux = jx + 0.5 * c.force[0][i], uy = jy + 0.5 * c.force[1][i], uz = jz + 0.5 * c.force[2][i];
    const double uxx = inertia * ux * ux, uyy = inertia * uy * uy, uzz = inertia * uz * uz;
    const double uu = uxx + uyy + uzz;
    const double p3xx_eq = 2 * uxx - uyy - uzz, pww_eq = uyy - uzz;

    const double e = -30 * f0 - 11 * axes + 8 * diagonals;
    const double eps = 12 * f0 - 4 * axes + diagonals;
    const double p3xx = 2 * sx - sy - sz + dxy + dxz - 2 * dyz;
    const double pi3xx = -4 * sx + 2 * (sy + sz) + dxy + dxz - 2 * dyz;
    const double pww = sy - sz + dxy - dxz;
    const double piww = 2 * (sz - sy) + dxy - dxz;

    const double s_nu = c.s_nu[i];
    const double d_e = -r.e / 2394 * (e - (19 * uu - 11 * rho));
    const double d_eps = -r.eps / 252 * (eps - (r.w_eps * rho + r.w_eps_j * uu));
    const double d_p3xx = -s_nu / 36 * (p3xx - p3xx_eq);
    const double d_pi3xx = -r.pi / 72 * (pi3xx - r.w_xx * p3xx_eq);
    const double d_pww = -s_nu / 12 * (pww - pww_eq);
    const double d_piww = -r.pi / 24 * (piww - r.w_xx * pww_eq);
    const double d_pxy = -s_nu / 4 * (pxy - nxy - inertia * ux * uy);
    const double d_pxz = -s_nu / 4 * (pxz - nxz - inertia * ux * uz);
    const double d_pyz = -s_nu / 4 * (pyz - nyz - inertia * uy * uz);

    const double d_qx = -r.q / 40 * (-4 * ax + x_in_xy + x_in_xz + 2.0 / 3 * ux);
    const double d_qy = -r.q / 40 * (-4 * ay + y_in_xy + y_in_yz + 2.0 / 3 * uy);
    const double d_qz = -r.q / 40 * (-4 * az + z_in_xz + z_in_yz + 2.0 / 3 * uz);
    const double d_mx = -r.m / 8 * (x_in_xy - x_in_xz);
    const double d_my = -r.m / 8 * (y_in_yz - y_in_xy);
    const double d_mz = -r.m / 8 * (z_in_xz - z_in_yz);
    // eqs. 18 and 19: the momentum takes the whole force
    const double d_jx = 0.1 * c.force[0][i], d_jy = 0.1 * c.force[1][i], d_jz = 0.1 * c.force[2][i];

    // back to populations: f* = f + M^T d
    out[0][i] = f0 - 30 * d_e + 12 * d_eps;
    const double axis = -11 * d_e - 4 * d_eps;
    const double axis_yz = axis - d_p3xx + 2 * d_pi3xx, split = d_pww - 2 * d_piww;
    const double even_x = axis + 2 * d_p3xx - 4 * d_pi3xx, even_y = axis_yz + split, even_z = axis_yz - split;
    const double odd_x = d_jx - 4 * d_qx, odd_y = d_jy - 4 * d_qy, odd_z = d_jz - 4 * d_qz;
    out[1][i] = f[1][i] + even_x + odd_x;
    out[2][i] = f[2][i] + even_x - odd_x;
    out[3][i] = f[3][i] + even_y + odd_y;
    out[4][i] = f[4][i] + even_y - odd_y;
    out[5][i] = f[5][i] + even_z + odd_z;
    out[6][i] = f[6][i] + even_z - odd_z;

    const double diagonal = 8 * d_e + d_eps, across = d_p3xx + d_pi3xx, fan = d_pww + d_piww;
    const double even_xy = diagonal + across + fan, even_xz = diagonal + across - fan;
    const double even_yz = diagonal - 2 * across;
    const double kx = d_jx + d_qx, ky = d_jy + d_qy, kz = d_jz + d_qz;
    const double xy_x = kx + d_mx, xy_y = ky - d_my;
    out[7][i] = f[7][i] + even_xy + d_pxy + xy_x + xy_y;
    out[10][i] = f[10][i] + even_xy + d_pxy - xy_x - xy_y;
    out[8][i] = f[8][i] + even_xy - d_pxy + xy_x - xy_y;
    out[9][i] = f[9][i] + even_xy - d_pxy - xy_x + xy_y;
    const double xz_x = kx - d_mx, xz_z = kz + d_mz;
    out[11][i] = f[11][i] + even_xz + d_pxz + xz_x + xz_z;
    out[14][i] = f[14][i] + even_xz + d_pxz - xz_x - xz_z;
    out[13][i] = f[13][i] + even_xz - d_pxz + xz_x - xz_z;
    out[12][i] = f[12][i] + even_xz - d_pxz - xz_x + xz_z;
    const double yz_y = ky + d_my, yz_z = kz - d_mz;
    out[15][i] = f[15][i] + even_yz + d_pyz + yz_y + yz_z;
    out[18][i] = f[18][i] + even_yz + d_pyz - yz_y - yz_z;
    out[17][i] = f[17][i] + even_yz - d_pyz + yz_y - yz_z;
    out[16][i] = f[16][i] + even_yz - d_pyz - yz_y + yz_z;
  }
}

}  // namespace capstan
