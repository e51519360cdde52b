#include "solver/fluid/quasisteady/quasisteady_flow.hpp"

#include <algorithm>
#include <cmath>

#include "solver/grid/full_approximation.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {
namespace {

// Relaxation factors measured to smooth well for 0.1 <= V <= 10. With one cycle a step and linear
// extrapolation in time, errors would grow from step to step if an eigenvalue of the cycle were below -1/3.
// With these factors none is.
constexpr Relaxation kRelaxation = {{0.9, 0.75}, 0.5};

constexpr int kMaxCycles = 100;
// Bounds of the estimated contraction factor of a cycle: at least 0.2 is assumed, and at most 0.95.
constexpr double kMinContraction = 0.2, kMaxContraction = 0.95;
// A W-cycle, except that each of the two coarsest grids is visited once: a second visit would take more time
// than it saves.
constexpr CycleShape kCycle{.pre = 0, .post = 2, .visits = 2, .single_visits = 2, .coarsest = 10};

// Cells on either side of the membrane over which the jump of the viscosity is smoothed.
constexpr int kSmoothing = 2;

GridGeometry finest_grid(double dx) { return {Vec3::Constant(dx / 2), dx}; }

}  // namespace

template <class T>
QuasisteadyFlow<T>::QuasisteadyFlow(const TriangleMesh& mesh, Orbits orbits,
                                    const QuasisteadyOptions& options)
    : options_(options),
      domain_{int(std::lround(options.box / options.dx)), false, options.is_uniform},
      boundary_(finest_grid(options.dx), orbits) {
  domain_.is_quarter = boundary_.has_symmetry();
  if (options.V != 1) viscosity_.emplace(finest_grid(options.dx), mesh, std::move(orbits));
}

template <class T>
FlowReport QuasisteadyFlow<T>::solve(double kt, const Points& positions, const Points& forces,
                                     Points& velocities) {
  if (!positions.allFinite() || !forces.allFinite()) return lost_flow(kLostMembrane);
  if (!put_membrane(positions)) return lost_flow(kOutsideOfDomain);
  if (viscosity_) put_viscosity(positions);
  extrapolate_to(kt);
  put_forces(forces);
  const FlowReport report = cycle_until_converged(positions, velocities);
  if (std::isfinite(report.error))
    grids_.front().add_momentum(-0.5, force_);
  else
    forget_flow();
  return report;
}

template <class T>
bool QuasisteadyFlow<T>::put_membrane(const Points& positions) {
  if (!boundary_.place(positions)) return false;
  const IndexBox capsule = boundary_.touched(kSmoothing);
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
                        options_.Re, viscosity_.has_value(), kRelaxation);
}

template <class T>
void QuasisteadyFlow<T>::put_viscosity(const Points& positions) {
  const IndexBox capsule = boundary_.touched(kSmoothing);
  ScalarField ratio;
  ratio.reset(capsule);
  viscosity_->update(positions, 1, options_.V, ratio);
  for (MomentGrid<T>& grid : grids_) {
    grid.set_viscosity(ratio);
    ratio = coarsened(ratio, 1);
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

// Between two solves the finest grid holds velocities u instead of momenta g = u + F/2: the force in a cell
// changes strongly while the membrane passes it, but the velocity changes little. So the velocities are
// extrapolated in time, not the momenta.
template <class T>
void QuasisteadyFlow<T>::put_forces(const Points& forces) {
  boundary_.spread(forces, kAmbientViscosity / options_.dx, force_);
  for (MomentGrid<T>& grid : grids_) {
    grid.clear_force();
    grid.add_convection();
  }
  grids_.front().add_force(force_);
  grids_.front().add_momentum(0.5, force_);
}

/// u = g - F/2, interpolated to the vertices, plus the undisturbed flow, evaluated exactly at the vertices.
template <class T>
void QuasisteadyFlow<T>::vertex_velocities(const Points& positions, Points& velocities) {
  velocity_.reset(force_.box());
  grids_.front().momentum(velocity_);
  add_scaled(-0.5, force_, velocity_);
  boundary_.interpolate(velocity_, velocities);
  velocities.row(0) += positions.row(1);
}

template <class T>
void QuasisteadyFlow<T>::cycle() {
  fas_cycle(std::span(grids_), kCycle);
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
FlowReport QuasisteadyFlow<T>::cycle_until_converged(const Points& positions, Points& velocities) {
  Points last;
  vertex_velocities(positions, last);
  FlowReport report;
  double last_change = 0;
  while (report.iterations < kMaxCycles) {
    cycle();
    ++report.iterations;
    vertex_velocities(positions, velocities);
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
  for (std::size_t i = 0; i < numbers.size(); i += 6)
    for (int axis = 0; axis < 3; ++axis)
      boxes_[i / 6].lo[axis] = int(numbers[i + 2 * axis]),
                 boxes_[i / 6].hi[axis] = int(numbers[i + 2 * axis + 1]);
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
