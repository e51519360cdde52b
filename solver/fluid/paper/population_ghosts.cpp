#include "solver/fluid/paper/population_ghosts.hpp"

#include <algorithm>

namespace capstan {
namespace {

/// Which interior cell a ghost at `side` (0 below, 1 above) of an axis with n cells copies.
int source_index(GhostRule rule, int side, int n) {
  const bool low_end = (rule == GhostRule::periodic) == (side == 1);
  return low_end ? 0 : n - 1;
}

int source_population(GhostRule rule, int q) { return rule == GhostRule::wall ? d3q19::opposite[q] : q; }

}  // namespace

// Axis after axis, each copying the ghosts of the one before: edges and corners come out right.
void fill_ghosts(PopulationField& f, const GhostRules& rules) {
  const auto [nx, ny, nz] = f.extent();
  for (int q = 0; q < d3q19::kQ; ++q)
    for (int side : {0, 1})
      for (int y = 0; y < ny; ++y)
        std::copy_n(f[source_population(rules.z, q)].row(y, source_index(rules.z, side, nz)), nx,
                    f[q].row(y, side ? nz : -1));
  for (int q = 0; q < d3q19::kQ; ++q)
    for (int side : {0, 1})
      for (int z = -1; z <= nz; ++z)
        std::copy_n(f[source_population(rules.y, q)].row(source_index(rules.y, side, ny), z), nx,
                    f[q].row(side ? ny : -1, z));
  for (int q = 0; q < d3q19::kQ; ++q)
    for (int side : {0, 1})
      for (int z = -1; z <= nz; ++z)
        for (int y = -1; y <= ny; ++y)
          f[q].row(y, z)[side ? nx : -1] =
              f[source_population(rules.x, q)].row(y, z)[source_index(rules.x, side, nx)];
}

}  // namespace capstan
