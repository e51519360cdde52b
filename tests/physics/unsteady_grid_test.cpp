// Exact unsteady flows in a channel and in a periodic box, on grids that cover the whole domain. The unknown
// is the deviation from the undisturbed shear flow (y, 0, 0), so the walls are at rest. Lengths are in units
// of half of the width of the channel; times t in units of 1/k.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "solver/fluid/quasisteady/moment_grid.hpp"
#include "solver/grid/full_approximation.hpp"

namespace capstan {
namespace {

using std::numbers::pi;

using Vector = std::array<double, 3>;
using Field = std::function<Vector(double x, double y, double z)>;

constexpr SideRules kChannel = {{{{SideRule::periodic, SideRule::periodic},
                                  {SideRule::wall, SideRule::wall},
                                  {SideRule::periodic, SideRule::periodic}}}};
constexpr SideRules kPeriodic = {{{{SideRule::periodic, SideRule::periodic},
                                   {SideRule::periodic, SideRule::periodic},
                                   {SideRule::periodic, SideRule::periodic}}}};
constexpr int kLevels = 3;

/// The flow in a box of cells x cells across the x axis, -1 < y, z < 1, which is short in x.
class UnsteadyBox {
 public:
  UnsteadyBox(int cells, const SideRules& rules, double Re, const Field& start) : dx_(2. / cells) {
    for (int level = 0; level < kLevels; ++level) {
      const int half = (cells >> level) / 2, along = 4 >> level;
      const IndexBox box{{-along, -half, -half}, {along, half, half}};
      grids_.emplace_back(box, box, rules, dx_ * (1 << level), Re, std::array<double, 2>{0.9, 0.75});
      grids_.back().add_momentum(1, on_cells(box, dx_ * (1 << level), start));
    }
  }

  /// Advances the flow to the time t under a force density (units mu_a k / a).
  void advance(double t, const Field& force) {
    const BackwardDifference difference = backward_difference(times_, t);
    const double extrapolation =
        times_.size() < 2 ? 0 : (t - times_.back()) / (times_.back() - times_.front());
    for (MomentGrid<double>& grid : grids_) {
      grid.clear_force();
      grid.add_time_derivative(difference);
      grid.extrapolate(extrapolation);
      grid.add_convection();
    }
    const double per_sweep = kAmbientViscosity * dx_ * dx_;
    const VectorField half = on_cells(grids_.front().box(), dx_, force, per_sweep / 2);
    grids_.front().add_force(on_cells(grids_.front().box(), dx_, force, per_sweep), half);
    grids_.front().add_momentum(1, half);
    for (int cycle = 0; cycle < 12; ++cycle) fas_cycle(std::span(grids_), {.pre = 0, .post = 2});
    grids_.front().add_momentum(-1, half);
    if (times_.size() == 2) times_.erase(times_.begin());
    times_.push_back(t);
  }
  /// To the time t in equal steps.
  void run(double t, int steps, const std::function<Field(double)>& force) {
    const double start = times_.back();
    for (int step = 1; step <= steps; ++step) {
      const double at = start + (t - start) * step / steps;
      advance(at, force(at));
    }
  }

  /// Largest difference of a component from an exact flow.
  double error(const Field& exact, int component) const {
    const VectorField u = momentum(), expected = on_cells(u.box(), dx_, exact);
    double largest = 0;
    for (int z = u.box().lo[2]; z < u.box().hi[2]; ++z)
      for (int y = u.box().lo[1]; y < u.box().hi[1]; ++y)
        for (int x = 0; x < u.box().size(0); ++x)
          largest = std::max(largest, std::abs(u.row(component, y, z)[x] - expected.row(component, y, z)[x]));
    return largest;
  }
  /// u_x next to the origin.
  double u_x() const { return momentum().row(0, 0, 0)[0]; }

 private:
  VectorField momentum() const {
    VectorField u;
    u.reset(grids_.front().box());
    grids_.front().momentum(u);
    return u;
  }
  static VectorField on_cells(const IndexBox& box, double dx, const Field& field, double factor = 1) {
    VectorField values;
    values.reset(box);
    for (int z = box.lo[2]; z < box.hi[2]; ++z)
      for (int y = box.lo[1]; y < box.hi[1]; ++y)
        for (int x = box.lo[0]; x < box.hi[0]; ++x) {
          const Vector value = field((x + 0.5) * dx, (y + 0.5) * dx, (z + 0.5) * dx);
          for (int c = 0; c < 3; ++c) values.row(c, y, z)[x - box.lo[0]] = factor * value[c];
        }
    return values;
  }

  double dx_;
  std::vector<MomentGrid<double>> grids_;
  std::vector<double> times_ = {0};
};

const Field kNone = [](double, double, double) { return Vector{}; };
std::function<Field(double)> constantly(const Field& field) {
  return [field](double) { return field; };
}

/// Fluid at rest between walls that move with the velocities -1 and 1 from t = 0 on: the deviation starts as
/// -y and decays. Sum of the modes sin(n pi y).
Field start_up(double t_over_Re) {
  return [=](double, double y, double) {
    double u = 0;
    for (int n = 1; n < 60; ++n)
      u += 2 * (n % 2 ? -1 : 1) / (n * pi) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * t_over_Re);
    return Vector{u, 0, 0};
  };
}

// The largest velocity is 1.
TEST(UnsteadyGrid, StartsUpCouetteFlowAsTheSeriesOfModes) {
  const auto at_rest = [](double, double y, double) { return Vector{-y, 0, 0}; };
  for (double Re : {0.01, 1.0}) {
    UnsteadyBox box(32, kChannel, Re, at_rest);
    for (double t : {0.05, 0.1, 0.2, 0.4}) {
      box.run(t * Re, 25, constantly(kNone));
      EXPECT_LT(box.error(start_up(t), 0), 3e-3) << "Re = " << Re << ", t/Re = " << t;
    }
  }
}

/// Flow between walls that oscillate in their plane, seen by an observer who moves with them: a force
/// cos(omega t) drives it. Re du/dt = u_yy + cos(omega t), u = 0 at the walls.
struct Oscillation {
  double Re, omega;

  Field force(double t) const {
    return [f = std::cos(omega * t)](double, double, double) { return Vector{f, 0, 0}; };
  }
  Field flow(double t) const {
    return [*this, t](double, double y, double) {
      const std::complex<double> i(0, 1), lambda = std::sqrt(i * omega * Re);
      const std::complex<double> amplitude =
          (1. - std::cosh(lambda * y) / std::cosh(lambda)) / (i * omega * Re);
      return Vector{(amplitude * std::exp(i * omega * t)).real(), 0, 0};
    };
  }
  UnsteadyBox start(int cells) const { return {cells, kChannel, Re, flow(0)}; }
  std::function<Field(double)> forces() const {
    return [*this](double t) { return force(t); };
  }
};

// The thickness of the boundary layer, sqrt(2/(omega Re)), is a third of half the width, and 5 cells.
TEST(UnsteadyGrid, FollowsOscillatingWallsWithTheirBoundaryLayer) {
  const Oscillation oscillation{.Re = 1, .omega = 18};
  const double amplitude = 1. / 18, period = 2 * pi / 18;
  UnsteadyBox box = oscillation.start(32);
  for (double periods : {0.5, 1.0, 1.6}) {
    box.run(periods * period, 50, oscillation.forces());
    EXPECT_LT(box.error(oscillation.flow(periods * period), 0), 0.01 * amplitude) << periods << " periods";
  }
}

TEST(UnsteadyGrid, IsOfSecondOrderInTheTimeStep) {
  const Oscillation oscillation{.Re = 1, .omega = 18};
  const auto velocity = [&](int steps) {
    UnsteadyBox box = oscillation.start(16);
    box.run(0.3, steps, oscillation.forces());
    return box.u_x();
  };
  const double coarse = velocity(20), medium = velocity(40), fine = velocity(80);
  EXPECT_NEAR(std::log2((coarse - medium) / (medium - fine)), 2, 0.2);
}

/// A vortex u = curl(psi e_x), psi = sin(pi y) sin(pi z)/pi. It decays at the rate 2 pi^2/Re, because the
/// pressure balances its convection. u_x, which the vortex draws out of the shear flow, is left out.
Field vortex(double t_over_Re) {
  return [decay = std::exp(-2 * pi * pi * t_over_Re)](double, double y, double z) {
    return Vector{0, decay * std::sin(pi * y) * std::cos(pi * z),
                  -decay * std::cos(pi * y) * std::sin(pi * z)};
  };
}

TEST(UnsteadyGrid, VortexDecaysAtTheRateOfViscosity) {
  for (double Re : {0.1, 10.0}) {
    UnsteadyBox box(32, kPeriodic, Re, vortex(0));
    for (double t : {0.02, 0.06}) {
      box.run(t * Re, 40, constantly(kNone));
      for (int component : {1, 2})
        EXPECT_LT(box.error(vortex(t), component), 5e-3) << "Re = " << Re << ", t/Re = " << t;
    }
  }
}

}  // namespace
}  // namespace capstan
