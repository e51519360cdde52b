#pragma once

namespace capstan {

class BenchReport;

/// What a multigrid cycle costs and does at the paper's resolution, on a uniform grid, on the composite, on a
/// quarter of it; and where the time of a whole step goes. What `capstan bench cycle` prints.
void bench_cycle(BenchReport& report);

}  // namespace capstan
