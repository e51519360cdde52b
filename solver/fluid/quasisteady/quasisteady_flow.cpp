#include "solver/fluid/quasisteady/quasisteady_flow.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "solver/grid/for_each_row.hpp"
#include "solver/grid/full_approximation.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {
namespace {

// Relaxation factors of alternate sweeps. With one cycle a step and linear extrapolation in time, errors
// would grow from step to step if an eigenvalue of the cycle were below -1/3. With these factors, and the
// sweeps of cycle_shape(), none is for 0.05 <= V <= 20.
constexpr std::array<double, 2> kRelaxation = {0.9, 0.75};

constexpr int kMaxCycles = 100;
// Bounds of the estimated contraction factor of a cycle: at least 0.2 is assumed, and at most 0.95.
constexpr double kMinContraction = 0.2, kMaxContraction = 0.95;
// A W-cycle, except that each of the three coarsest grids is visited once: a second visit would take more
// time than it saves. In thin fluid there are twice as many sweeps: with two, errors grow from step to step
// at V = 0.05. With four sweeps, errors grow around a red cell of V = 4 and more.
CycleShape cycle_shape(double V) {
  constexpr double kThin = 0.25;
  return {.pre = 0, .post = V < kThin ? 4 : 2, .visits = 2, .single_visits = 3, .coarsest = 10};
}

// A membrane that becomes unstable would change its volume, if that was not kept.
constexpr double kMaxLeak = 0.1;
constexpr const char* kLeak =
    "the flow through the membrane is more than a tenth of its volume per unit of kt";

GridGeometry finest_grid(double dx) { return {Vec3::Constant(dx / 2), dx}; }

}  // namespace

template <class T>
QuasisteadyFlow<T>::QuasisteadyFlow(const TriangleMesh& mesh, Orbits orbits,
                                    const QuasisteadyOptions& options)
    : options_(options),
      domain_{int(std::lround(options.box / options.dx)), false, options.is_uniform},
      coupling_(finest_grid(options.dx), mesh, orbits, options.V, options.volume) {
  domain_.is_quarter = coupling_.has_symmetry();
  if (options.V != 1) viscosity_.emplace(finest_grid(options.dx), mesh, std::move(orbits));
}

template <class T>
FlowReport QuasisteadyFlow<T>::solve(double kt, const Points& positions, const Points& forces,
                                     Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  if (!put_membrane(positions)) return lost_flow(kOutsideOfDomain);
  if (options_.is_unsteady && solved_at_.empty()) return start_undisturbed(kt, positions, velocities);
  if (viscosity_) put_viscosity(positions);
  clear_forces(kt);
  extrapolate_to(kt);
  put_forces(forces);
  const FlowReport report = cycle_until_converged(velocities);
  if (!std::isfinite(report.error)) {
    forget_flow();
    return report;
  }
  grids_.front().add_momentum(-1, half_force_);
  if (coupling_.leak() > kMaxLeak) return lost_flow(kLeak);
  return report;
}

template <class T>
bool QuasisteadyFlow<T>::put_membrane(const Points& positions) {
  if (!coupling_.place(positions)) return false;
  const IndexBox capsule = coupling_.touched();
  if (!domain_.box(0).contains(capsule)) return false;
  move_boxes(capsule);
  return true;
}

/// Moves the grids with the capsule, coarse ones first: new cells of a grid are interpolated from the next
/// coarser one.
template <class T>
void QuasisteadyFlow<T>::move_boxes(const IndexBox& capsule) {
  const std::vector<IndexBox> boxes = plan_boxes(domain_, capsule, boxes_);
  if (grids_.empty()) make_grids(boxes);
  for (int grid = int(boxes.size()) - 2; grid >= 0; --grid)
    if (boxes[grid] != grids_[grid].box()) grids_[grid].move_to(boxes[grid], grids_[grid + 1]);
  boxes_ = boxes;
}

template <class T>
void QuasisteadyFlow<T>::make_grids(const std::vector<IndexBox>& boxes) {
  for (int grid = 0; grid < int(boxes.size()); ++grid)
    grids_.emplace_back(boxes[grid], domain_.box(grid), domain_.rules(), options_.dx * (1 << grid),
                        options_.Re, kRelaxation);
}

/// The initial condition of unsteady flow.
template <class T>
FlowReport QuasisteadyFlow<T>::start_undisturbed(double kt, const Points& positions, Points& velocities) {
  solved_at_ = {kt};
  velocities = Points::Zero(3, positions.cols());
  velocities.row(0) = positions.row(1);
  return {};
}

/// D <- 0, or the part of the time derivative that is known. The flows of the last two solves are needed, so
/// this precedes the extrapolation, which overwrites one of them.
template <class T>
void QuasisteadyFlow<T>::clear_forces(double kt) {
  for (MomentGrid<T>& grid : grids_) grid.clear_force();
  if (!options_.is_unsteady) return;
  assert(kt > solved_at_.back());
  const BackwardDifference difference = backward_difference(solved_at_, kt);
  for (MomentGrid<T>& grid : grids_) grid.add_time_derivative(difference);
}

/// Cells of coarser grids have the mean viscosity of their children.
template <class T>
void QuasisteadyFlow<T>::put_viscosity(const Points& positions) {
  ratio_.reset(coupling_.touched());
  viscosity_->update(positions, layer_viscosity(options_.V), ratio_);
  grids_.front().set_viscosity(ratio_);
  ScalarField coarse = ratio_;
  for (std::size_t grid = 1; grid < grids_.size(); ++grid) {
    coarse = coarsened(coarse, 1);
    grids_[grid].set_viscosity(coarse);
  }
}

// Linear extrapolation in time. Its error, which the cycles must reduce, is the second difference of the flow
// in time.
template <class T>
void QuasisteadyFlow<T>::extrapolate_to(double kt) {
  if (!solved_at_.empty() && kt == solved_at_.back()) return;
  const double weight =
      solved_at_.size() < 2 ? 0 : (kt - solved_at_.back()) / (solved_at_.back() - solved_at_.front());
  for (MomentGrid<T>& grid : grids_) grid.extrapolate(weight);
  if (solved_at_.size() == 2) solved_at_.erase(solved_at_.begin());
  solved_at_.push_back(kt);
}

// Between two solves the finest grid holds velocities u instead of momenta g = u + F/(2 R): the force in a
// cell changes strongly while the membrane passes it, but the velocity changes little. So the velocities are
// extrapolated in time, not the momenta.
template <class T>
void QuasisteadyFlow<T>::put_forces(const Points& forces) {
  coupling_.spread(forces, kAmbientViscosity / options_.dx, force_);
  for (MomentGrid<T>& grid : grids_) grid.add_convection();
  put_half_force();
  grids_.front().add_force(force_, half_force_);
  grids_.front().add_momentum(1, half_force_);
}

template <class T>
void QuasisteadyFlow<T>::put_half_force() {
  half_force_.reset(force_.box());
  for_each_row_in_order(force_.box(), [&](int y, int z) {
    const double* ratio = viscosity_ ? ratio_.row(0, y, z) : nullptr;
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < force_.box().size(0); ++i)
        half_force_.row(c, y, z)[i] = force_.row(c, y, z)[i] / (2 * (ratio ? ratio[i] : 1));
  });
}

/// u = g - F/(2 R), read at the vertices.
template <class T>
void QuasisteadyFlow<T>::vertex_velocities(Points& velocities) {
  velocity_.reset(force_.box());
  grids_.front().momentum(velocity_);
  add_scaled(-1, half_force_, velocity_);
  coupling_.read(velocity_, velocities);
}

template <class T>
void QuasisteadyFlow<T>::cycle() {
  fas_cycle(std::span(grids_), cycle_shape(options_.V));
}

/// Makes the next solve start from the undisturbed flow, because the present flow is not finite.
template <class T>
void QuasisteadyFlow<T>::forget_flow() {
  grids_.clear();
  solved_at_.clear();
}

// The error after a cycle is estimated by the sum of the changes in all further cycles, which is change * rho
// / (1 - rho) for a contraction factor rho of a cycle. Differs from the paper, which stops on the change
// itself (eq. 26).
template <class T>
FlowReport QuasisteadyFlow<T>::cycle_until_converged(Points& velocities) {
  Points last;
  vertex_velocities(last);
  FlowReport report;
  double last_change = 0;
  while (report.iterations < kMaxCycles) {
    cycle();
    ++report.iterations;
    vertex_velocities(velocities);
    const double change = (velocities - last).norm() / velocities.norm();
    if (!std::isfinite(change)) return lost_flow("the flow is not finite");
    // The first ratios of changes are smaller than the contraction factor of later cycles, in which the
    // smooth error dominates: hence the minimum.
    const double contraction = report.iterations > 1
                                   ? std::clamp(change / last_change, kMinContraction, kMaxContraction)
                                   : first_contraction_;
    if (report.iterations == 2) first_contraction_ = contraction;
    report.error = change * contraction / (1 - contraction);
    if (report.error <= options_.tolerance) return report;
    last_change = change;
    last = velocities;
  }
  report.converged = false;
  report.reason = "the multigrid cycles did not converge: raise tolerance, or take the fluid stokes";
  return report;
}

template <class T>
void QuasisteadyFlow<T>::save(StateArchive& archive) const {
  std::vector<double> boxes;
  for (std::size_t grid = 0; grid < grids_.size(); ++grid) {
    for (int axis = 0; axis < 3; ++axis)
      boxes.push_back(boxes_[grid].lo[axis]), boxes.push_back(boxes_[grid].hi[axis]);
    MomentGrid<T>::visit_state(grids_[grid], [&](const char* name, const RowField<T>& field) {
      const auto numbers = field.data();
      archive.put("fluid/" + std::to_string(grid) + "/" + name,
                  std::vector<double>(numbers.begin(), numbers.end()));
    });
  }
  archive.put("fluid/boxes", std::move(boxes));
  archive.put("fluid/solved_at", solved_at_);
  archive.put("fluid/contraction", first_contraction_);
}

template <class T>
void QuasisteadyFlow<T>::load(const StateArchive& archive) {
  const auto numbers = archive.get("fluid/boxes");
  boxes_.resize(numbers.size() / 6);
  auto next = numbers.begin();
  for (auto& box : boxes_)
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = int(*next++);
      box.hi[axis] = int(*next++);
    }
  grids_.clear();
  make_grids(boxes_);
  for (std::size_t grid = 0; grid < grids_.size(); ++grid)
    MomentGrid<T>::visit_state(grids_[grid], [&](const char* name, RowField<T>& field) {
      const auto saved = archive.get("fluid/" + std::to_string(grid) + "/" + name);
      const auto state = field.data();
      if (saved.size() != state.size()) throw std::runtime_error("checkpoint has another grid");
      std::ranges::transform(saved, state.begin(), [](double number) { return T(number); });
    });
  const auto times = archive.get("fluid/solved_at");
  solved_at_.assign(times.begin(), times.end());
  first_contraction_ = archive.number("fluid/contraction");
}

template class QuasisteadyFlow<float>;
template class QuasisteadyFlow<double>;

}  // namespace capstan
