#pragma once

namespace capstan {

/// What a multigrid cycle costs and does at the paper's resolution, on a uniform grid, on the composite, on a
/// quarter of it; and where the time of a whole step goes. What `capstan bench cycle` prints. \return the
/// exit code
int bench_cycle(bool json);

}  // namespace capstan
