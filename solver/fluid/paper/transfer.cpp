#include "solver/fluid/paper/transfer.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "solver/grid/vector_units.hpp"

namespace capstan {
namespace {

using namespace d3q19;

using PopulationMatrix = std::array<std::array<double, kQ>, kQ>;

/// Factors of density, momentum, stress-like moments (e, eps, p), energy flux, and the orders above it.
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

/// The linear part of the equilibrium of moment k: its coefficient of moment `conserved`.
double equilibrium(const MrtRates& rates, int k, int conserved) {
  if (conserved == m_rho) return k == m_rho ? 1 : k == m_e ? -11 : k == m_eps ? rates.w_eps : 0;
  if (k == conserved) return 1;
  return k == conserved + 1 ? -2.0 / 3 : 0;  // q = -2/3 j
}

/// Scales conserved moments and the deviations of the others from their equilibrium: M^-1 T M.
PopulationMatrix scaling(const MomentFactors& factors, const MrtRates& rates) {
  PopulationMatrix moments{};  // T M
  for (int k = 0; k < kQ; ++k)
    for (int q = 0; q < kQ; ++q) {
      moments[k][q] = factor_of(factors, k) * moment_row(k, q);
      for (int conserved : {int(m_rho), int(m_jx), int(m_jy), int(m_jz)})
        if (k != conserved)
          moments[k][q] += (factor_of(factors, conserved) - factor_of(factors, k)) *
                           equilibrium(rates, k, conserved) * moment_row(conserved, q);
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

/// Applies the matrix to every interior cell.
void apply(const PopulationMatrix& matrix, PopulationField& f) {
  const int nx = f.extent().nx, ny = f.extent().ny, nz = f.extent().nz;
#pragma omp parallel
  {
    std::vector<double> row(std::size_t(kQ) * nx);
#pragma omp for schedule(static)
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y) {
        for (int q = 0; q < kQ; ++q) std::copy_n(f[q].row(y, z), nx, &row[std::size_t(q) * nx]);
        for (int q = 0; q < kQ; ++q) {
          std::fill_n(f[q].row(y, z), nx, 0.0);
          for (int p = 0; p < kQ; ++p)
            if (matrix[q][p] != 0) multiply_add(f[q].row(y, z), &row[std::size_t(p) * nx], matrix[q][p], nx);
        }
      }
  }
}

/// Mean of the eight children.
void average(const PopulationField& fine, PopulationField& coarse) {
  const int nx = coarse.extent().nx, ny = coarse.extent().ny, nz = coarse.extent().nz;
  for (int q = 0; q < kQ; ++q) {
#pragma omp parallel for schedule(static)
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y) {
        const double *a = fine[q].row(2 * y, 2 * z), *b = fine[q].row(2 * y + 1, 2 * z);
        const double *c = fine[q].row(2 * y, 2 * z + 1), *d = fine[q].row(2 * y + 1, 2 * z + 1);
        double* out = coarse[q].row(y, z);
        for (int x = 0; x < nx; ++x) {
          const int i = 2 * x, k = 2 * x + 1;
          out[x] = 0.125 * (a[i] + a[k] + b[i] + b[k] + c[i] + c[k] + d[i] + d[k]);
        }
      }
  }
}

}  // namespace

LevelTransfer::LevelTransfer(const MrtRates& rates)
    : state_to_coarse_(scaling(kStateToCoarse, rates)),
      residual_to_coarse_(scaling(kResidualToCoarse, rates)),
      state_to_fine_(scaling(kStateToFine, rates)) {}

void LevelTransfer::restrict_state(const PopulationField& fine, PopulationField& coarse) const {
  average(fine, coarse);
  apply(state_to_coarse_, coarse);
}

void LevelTransfer::restrict_residual(const PopulationField& fine, PopulationField& coarse) const {
  average(fine, coarse);
  apply(residual_to_coarse_, coarse);
}

void LevelTransfer::scale_to_finer(PopulationField& coarse) const { apply(state_to_fine_, coarse); }

// A child's centre is a quarter of a coarse cell from its parent's: weights 3/4 and 1/4 in each direction.
void add_interpolated(const PopulationField& coarse, PopulationField& fine) {
  const int nx = coarse.extent().nx, ny = coarse.extent().ny, nz = coarse.extent().nz;
  for (int q = 0; q < kQ; ++q) {
#pragma omp parallel
    {
      std::vector<double> plane_row(std::size_t(nx) + 2);
#pragma omp for schedule(static)
      for (int fine_z = 0; fine_z < 2 * nz; ++fine_z)
        for (int fine_y = 0; fine_y < 2 * ny; ++fine_y) {
          const int y = fine_y / 2, z = fine_z / 2;
          const int near_y = fine_y % 2 ? y + 1 : y - 1, near_z = fine_z % 2 ? z + 1 : z - 1;
          const double *a = coarse[q].row(y, z), *b = coarse[q].row(near_y, z);
          const double *c = coarse[q].row(y, near_z), *d = coarse[q].row(near_y, near_z);
          double* row = plane_row.data() + 1;
          for (int x = -1; x <= nx; ++x)
            row[x] = 9.0 / 16 * a[x] + 3.0 / 16 * (b[x] + c[x]) + 1.0 / 16 * d[x];
          double* out = fine[q].row(fine_y, fine_z);
          for (int x = 0; x < nx; ++x) {
            out[2 * x] += 0.75 * row[x] + 0.25 * row[x - 1];
            out[2 * x + 1] += 0.75 * row[x] + 0.25 * row[x + 1];
          }
        }
    }
  }
}

}  // namespace capstan
