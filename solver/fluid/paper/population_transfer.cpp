#include "solver/fluid/paper/population_transfer.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "solver/grid/transfers.hpp"
#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

using namespace d3q19;

using PopulationMatrix = std::array<std::array<double, kQ>, kQ>;

/// Factors for density, momentum, stress-like moments (e, eps, p), energy flux, and moments of third and
/// fourth order.
struct MomentFactors {
  double rho, j, stress, flux, third, fourth;
};
constexpr MomentFactors kStateToCoarse = {2, 1, 2, 4, 4, 4};
constexpr MomentFactors kStateToFine = {0.5, 1, 0.5, 0.25, 0.25, 0.25};
constexpr MomentFactors kResidualToCoarse = {2, 4, 2, 1, 1, 1};

double factor_of(const MomentFactors& factors, int moment) {
  switch (moment) {
    case m_rho:
      return factors.rho;
    case m_jx:
    case m_jy:
    case m_jz:
      return factors.j;
    case m_qx:
    case m_qy:
    case m_qz:
      return factors.flux;
    case m_x:
    case m_y:
    case m_z:
      return factors.third;
    case m_3pixx:
    case m_piww:
      return factors.fourth;
    default:
      return factors.stress;
  }
}

/// Derivative of the equilibrium of moment k with respect to the conserved moment (rho, jx, jy or jz), at
/// rest.
double equilibrium_slope(const MrtRates& rates, int k, int conserved) {
  if (conserved == m_rho) return k == m_rho ? 1 : k == m_e ? -11 : k == m_eps ? rates.w_eps : 0;
  if (k == conserved) return 1;
  return k == conserved + 1 ? -2.0 / 3 : 0;  // q = -2/3 j
}

/// The matrix M^-1 T M for populations. T multiplies the conserved moments by their factors, and the
/// deviations of the other moments from their equilibria by theirs.
PopulationMatrix scaling(const MomentFactors& factors, const MrtRates& rates) {
  PopulationMatrix moments{};  // T M
  for (int k = 0; k < kQ; ++k)
    for (int q = 0; q < kQ; ++q) {
      moments[k][q] = factor_of(factors, k) * moment_row(k, q);
      for (int conserved : {int(m_rho), int(m_jx), int(m_jy), int(m_jz)})
        if (k != conserved)
          moments[k][q] += (factor_of(factors, conserved) - factor_of(factors, k)) *
                           equilibrium_slope(rates, k, conserved) * moment_row(conserved, q);
    }
  PopulationMatrix matrix{};
  for (int out = 0; out < kQ; ++out)
    for (int in = 0; in < kQ; ++in)
      for (int k = 0; k < kQ; ++k) matrix[out][in] += moment_row(k, out) / moment_norm2(k) * moments[k][in];
  return matrix;
}

CAPSTAN_VECTOR_UNITS void multiply_add(double* __restrict out, const double* __restrict in, double factor,
                                       int n) {
  for (int i = 0; i < n; ++i) out[i] += factor * in[i];
}

/// Multiplies the populations of every cell, ghosts excluded, by the matrix.
void apply(const PopulationMatrix& matrix, RowField<double>& f) {
  const int nx = f.box().size(0);
  for_each_row(f.box(), [&](int y, int z) {
    thread_local std::vector<double> row;
    row.resize(std::size_t(kQ) * nx);
    for (int q = 0; q < kQ; ++q) std::copy_n(f.row(q, y, z), nx, &row[std::size_t(q) * nx]);
    for (int q = 0; q < kQ; ++q) {
      std::fill_n(f.row(q, y, z), nx, 0.0);
      for (int p = 0; p < kQ; ++p)
        if (matrix[q][p] != 0) multiply_add(f.row(q, y, z), &row[std::size_t(p) * nx], matrix[q][p], nx);
    }
  });
}

// The stencils of the next two functions are those of grid/transfers.hpp. They are evaluated here in the
// order of the paper's scheme: another order, or fused multiply-adds, would change its results in the last
// bits.

void average(const RowField<double>& fine, RowField<double>& coarse) {
  const IndexBox& box = coarse.box();
  const std::ptrdiff_t component = fine.strides().component;
  for_each_row(box, [&](int y, int z) {
    auto [a, b, c, d] = rows_of_children(fine, box.lo[0], y, z);
    for (int q = 0; q < kQ; ++q) {
      double* out = coarse.row(q, y, z);
      for (int x = 0; x < box.size(0); ++x) {
        const int i = 2 * x, k = 2 * x + 1;
        out[x] = 0.125 * (a[i] + a[k] + b[i] + b[k] + c[i] + c[k] + d[i] + d[k]);
      }
      a += component, b += component, c += component, d += component;
    }
  });
}

}  // namespace

PopulationTransfer::PopulationTransfer(const MrtRates& rates)
    : state_to_coarse_(scaling(kStateToCoarse, rates)),
      residual_to_coarse_(scaling(kResidualToCoarse, rates)),
      state_to_fine_(scaling(kStateToFine, rates)) {}

void PopulationTransfer::restrict_state(const RowField<double>& fine, RowField<double>& coarse) const {
  average(fine, coarse);
  apply(state_to_coarse_, coarse);
}

void PopulationTransfer::restrict_residual(const RowField<double>& fine, RowField<double>& coarse) const {
  average(fine, coarse);
  apply(residual_to_coarse_, coarse);
}

void PopulationTransfer::scale_to_finer(RowField<double>& coarse) const { apply(state_to_fine_, coarse); }

void add_interpolated(const RowField<double>& coarse, RowField<double>& fine) {
  const int nx = coarse.box().size(0);
  const std::ptrdiff_t component = coarse.strides().component;
  for_each_row(fine.box(), [&](int y, int z) {
    thread_local std::vector<double> in_yz;
    in_yz.resize(std::size_t(nx) + 2);
    double* row = in_yz.data() + 1;
    auto [a, b, c, d] = rows_around(coarse, coarse.box().lo[0], y, z);
    for (int q = 0; q < kQ; ++q) {
      for (int x = -1; x <= nx; ++x) row[x] = 9.0 / 16 * a[x] + 3.0 / 16 * (b[x] + c[x]) + 1.0 / 16 * d[x];
      double* out = fine.row(q, y, z);
      for (int x = 0; x < nx; ++x) {
        out[2 * x] += 0.75 * row[x] + 0.25 * row[x - 1];
        out[2 * x + 1] += 0.75 * row[x] + 0.25 * row[x + 1];
      }
      a += component, b += component, c += component, d += component;
    }
  });
}

}  // namespace capstan
