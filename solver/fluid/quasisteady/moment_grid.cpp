#include "solver/fluid/quasisteady/moment_grid.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "solver/fluid/quasisteady/convection.hpp"
#include "solver/fluid/quasisteady/moment_images.hpp"
#include "solver/grid/transfers.hpp"

namespace capstan {
namespace {

//                                                     rho gx gy gz
constexpr std::array<double, kMoments> kStateToCoarse = {2, 1, 1, 1};
constexpr std::array<double, kMoments> kStateToFine = {0.5, 1, 1, 1};
constexpr std::array<double, kMoments> kResidualToCoarse = {2, 4, 4, 4};

/// Momentum of `field` += factor * vectors.
template <class T>
void add_vectors(double factor, const VectorField& vectors, RowField<T>& field) {
  const IndexBox& box = vectors.box();
  for_each_row_in_order(box, [&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      T* row = field.row(kGx + c, y, z) + (box.lo[0] - field.box().lo[0]);
      for (int i = 0; i < box.size(0); ++i) row[i] += T(factor * vectors.row(c, y, z)[i]);
    }
  });
}

}  // namespace

template <class T>
MomentGrid<T>::MomentGrid(const IndexBox& box, const IndexBox& domain, const SideRules& domain_rules,
                          double dx, double Re, const std::array<double, 2>& relaxation)
    : domain_(domain),
      domain_rules_(domain_rules),
      dx_(dx),
      inertia_(Re * kAmbientViscosity * dx),
      relaxation_(relaxation),
      rules_(rules_of(box)),
      state_{RowField<T>(box, kMoments), RowField<T>(box, kMoments)},
      defect_(box, kMoments),
      scratch_{RowField<T>(box, kMoments), RowField<T>(box, kMoments)} {}

template <class T>
SideRules MomentGrid<T>::rules_of(const IndexBox& box) const {
  SideRules rules = domain_rules_;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo[axis] != domain_.lo[axis]) rules.side[axis][0] = SideRule::interpolated;
    if (box.hi[axis] != domain_.hi[axis]) rules.side[axis][1] = SideRule::interpolated;
  }
  return rules;
}

template <class T>
FluidRow<T> MomentGrid<T>::fluid_row(int y, int z, std::optional<double> gamma) {
  return {.m = state_.now.row(0, y, z),
          .defect = defect_.row(0, y, z),
          .out = scratch_.next.row(0, y, z),
          .strides = state_.now.strides(),
          .count = box().size(0),
          .keep = T(gamma ? 1 - *gamma : -1),
          .blend = T(gamma ? *gamma : 1),
          .g_keep = T(gamma ? 1 - *gamma : -1 - rate_),
          .g_blend = T(gamma ? *gamma / (1 + rate_) : 1),
          .shear = T(shear(y)),
          .lift = T(lift())};
}

template <class T>
LinkRow<T> MomentGrid<T>::link_row(int y, int z) {
  return {.m = state_.now.row(0, y, z),
          .defect = defect_.row(0, y, z),
          .out = scratch_.next.row(0, y, z),
          .strides = state_.now.strides(),
          .ratio = ratio_->row(0, y, z),
          .ratio_strides = ratio_->strides(),
          .count = box().size(0),
          .dx = T(dx_),
          .rate = T(rate_),
          .shear = T(shear(y)),
          .lift = T(lift())};
}

/// scratch_.next <- the moments after relaxation by gamma; without gamma, the residual. Every row is written
/// by one thread and depends only on values that stay constant during the sweep. So the result does not
/// depend on the number of threads.
template <class T>
void MomentGrid<T>::sweep(std::optional<double> gamma) {
  fill_ghosts(state_.now, rules_, kMomentImages);
  for_each_row(box(), [&](int y, int z) {
    if (!ratio_ || !has_ratio_[row_index(y, z)])
      sweep_fluid(fluid_row(y, z, gamma));
    else if (gamma)
      relax_links(link_row(y, z), T(*gamma));
    else
      put_residual_of_links(link_row(y, z));
  });
}

template <class T>
void MomentGrid<T>::relax() {
  sweep(relaxation_[sweep_parity_]);
  sweep_parity_ = 1 - sweep_parity_;
  copy_interpolated(state_.now, scratch_.next, rules_);
  std::swap(state_.now, scratch_.next);
}

template <class T>
void MomentGrid<T>::restrict_to(MomentGrid& coarse) {
  average_children(state_.now, coarse.state_.now, coarsened(box()), kStateToCoarse);
  sweep_residual();
  coarse.take_defect(*this);
}

// Eq. 24: D_H = A_H(I m) + I' r_h, in the cells whose whole stencil is covered by the fine grid. In all other
// cells D is unchanged. With the old D the residual of this grid is r_H = D - A_H(I m). The new value of D is
// therefore D - r_H + I' r_h.
template <class T>
void MomentGrid<T>::take_defect(MomentGrid& fine) {
  sweep_residual();
  const IndexBox inner = covered_stencils(fine);
  RowField<T>& fine_residual = scratch_.start;
  average_children(fine.scratch_.next, fine_residual, inner, kResidualToCoarse);
  add_difference(fine_residual, scratch_.next, defect_, inner);
  if (is_whole()) subtract_mean_mass_defect();
  scratch_.start = state_.now;
}

/// The cells that the fine grid covers together with all their neighbours.
template <class T>
IndexBox MomentGrid<T>::covered_stencils(const MomentGrid& fine) const {
  IndexBox inner = coarsened(fine.box());
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.lo[axis] != domain_.lo[axis]) ++inner.lo[axis];
    if (inner.hi[axis] != domain_.hi[axis]) --inner.hi[axis];
  }
  return inner;
}

/// A domain without an outlet has a steady solution only if its sources of mass sum up to zero.
template <class T>
void MomentGrid<T>::subtract_mean_mass_defect() {
  const IndexBox& cells = box();
  double sum = 0;  // in a fixed order, so that rounding does not depend on the number of threads
  for_each_row_in_order(cells, [&](int y, int z) {
    const T* row = defect_.row(kRho, y, z);
    for (int i = 0; i < cells.size(0); ++i) sum += row[i];
  });
  const T mean = T(sum / double(cells.cells()));
  for_each_row_in_order(cells, [&](int y, int z) {
    T* row = defect_.row(kRho, y, z);
    for (int i = 0; i < cells.size(0); ++i) row[i] -= mean;
  });
}

// Eq. 25.
template <class T>
void MomentGrid<T>::correct_from(MomentGrid& coarse) {
  coarse.take_change();
  add_linear(coarse.scratch_.start, state_.now, box(), kStateToFine);
  interpolate_ghosts(coarse);
}

/// scratch_.start <- m - scratch_.start, ghosts included.
template <class T>
void MomentGrid<T>::take_change() {
  fill_ghosts(state_.now, rules_, kMomentImages);
  take_difference(state_.now.data(), scratch_.start.data());
}

template <class T>
void MomentGrid<T>::interpolate_ghosts(const MomentGrid& coarse) {
  const IndexBox all = with_interpolated_ghosts(box());
  IndexBox rest = all;  // the ghosts that no layer covers yet
  for (int axis = 0; axis < 3; ++axis) {
    IndexBox low = rest, high = rest;
    low.hi[axis] = rest.lo[axis] = box().lo[axis];
    high.lo[axis] = rest.hi[axis] = box().hi[axis];
    for (const IndexBox& layer : {low, high})
      if (layer.cells() > 0) interpolate(coarse.state_.now, state_.now, layer, kStateToFine);
  }
}

template <class T>
void MomentGrid<T>::set_viscosity(const ScalarField& ratio) {
  if (!ratio_) ratio_.emplace(box(), 1);
  std::ranges::fill(ratio_->data(), T(1));
  has_ratio_.assign(std::size_t(box().size(1)) * box().size(2), false);
  const int first = ratio.box().lo[0] - box().lo[0], count = ratio.box().size(0);
  const IndexBox rows{{0, box().lo[1], box().lo[2]}, {1, box().hi[1], box().hi[2]}};
  for_each_row_in_order(ratio.box(), [&](int y, int z) {
    const std::span<const double> ratios(ratio.row(0, y, z), std::size_t(count));
    if (std::ranges::all_of(ratios, [](double R) { return R == 1; })) return;
    std::ranges::transform(ratios, ratio_->row(0, y, z) + first, [](double R) { return T(R); });
    const IndexBox near{{0, y - 1, z - 1}, {1, y + 2, z + 2}};
    for_each_row_in_order(intersection(near, rows),
                          [&](int near_y, int near_z) { has_ratio_[row_index(near_y, near_z)] = true; });
  });
  fill_ghosts(*ratio_, rules_, kScalarImages);
}

template <class T>
void MomentGrid<T>::clear_force() {
  std::ranges::fill(defect_.data(), T(0));
}

template <class T>
void MomentGrid<T>::add_time_derivative(const BackwardDifference& difference) {
  rate_ = inertia_ * dx_ * difference.now;
  subtract_known_part(difference, state_.now, state_.before, inertia_ * dx_, defect_);
}

/// The force itself. The sweeps have time derivative and convection of the momentum; those of the velocity,
/// which is smaller by `half`, are meant.
template <class T>
void MomentGrid<T>::add_force(const VectorField& force, const VectorField& half) {
  add_vectors(1, force, defect_);
  if (rate_ != 0) add_vectors(rate_, half, defect_);
  if (inertia_ != 0) add_carried(half);
}

/// D += the convection of `half` by the undisturbed flow, and of the undisturbed flow by it.
template <class T>
void MomentGrid<T>::add_carried(const VectorField& half) {
  const IndexBox& cells = half.box();
  const int first = cells.lo[0] - box().lo[0], count = cells.size(0);
  for_each_row_in_order(cells, [&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      const double* row = half.row(c, y, z);
      T* to = defect_.row(kGx + c, y, z) + first;
      for (int i = 1; i + 1 < count; ++i) to[i] += T(shear(y) * (row[i + 1] - row[i - 1]));
    }
    const double* along_y = half.row(1, y, z);
    T* to = defect_.row(kGx, y, z) + first;
    for (int i = 0; i < count; ++i) to[i] += T(lift() * along_y[i]);
  });
}

template <class T>
void MomentGrid<T>::add_convection() {
  if (inertia_ == 0) return;
  fill_ghosts(state_.now, rules_, kMomentImages);
  subtract_convection(state_.now, inertia_, defect_);
}

template <class T>
void MomentGrid<T>::add_momentum(double factor, const VectorField& momentum) {
  add_vectors(factor, momentum, state_.now);
}

/// The weight of the density in an extrapolation with the weight `weight` of the momentum. In unsteady flow
/// the pressure keeps the flow free of divergence. If it starts from a linear extrapolation and a solve is
/// one cycle, errors grow from step to step where inertia exceeds viscosity, as in projection methods with
/// such a pressure (Guermond, Minev and Shen 2006). With half of this factor, errors grew slowly at Re = 1,
/// dx = 0.1 and kdt = 0.02. With this one they decayed for 0.05 <= Re <= 10 and 0.2 <= V <= 20 (measured).
template <class T>
double MomentGrid<T>::density_weight(double weight) const {
  return weight / (1 + 2 * rate_);
}

template <class T>
void MomentGrid<T>::extrapolate(double weight) {
  const IndexBox with_ghosts = grown(box(), 1);
  for_each_row(with_ghosts, [&](int y, int z) {
    const std::span<T> now = state_.now.whole_row(y, z), before = state_.before.whole_row(y, z);
    const std::size_t momentum = state_.now.strides().component;  // behind the densities
    capstan::extrapolate(now.first(momentum), before.first(momentum), density_weight(weight));
    capstan::extrapolate(now.subspan(momentum), before.subspan(momentum), weight);
  });
}

template <class T>
void MomentGrid<T>::move_to(const IndexBox& box, MomentGrid& coarse) {
  rules_ = rules_of(box);
  for (auto [fine, parents] :
       {std::pair{&state_.now, &coarse.state_.now}, std::pair{&state_.before, &coarse.state_.before}}) {
    fill_ghosts(*parents, coarse.rules_, kMomentImages);
    RowField<T>& moved = scratch_.next;
    moved.reset(box);
    interpolate(*parents, moved, with_interpolated_ghosts(box), kStateToFine);
    copy_cells(*fine, moved);
    std::swap(*fine, moved);
  }
  for (RowField<T>* field : {&scratch_.next, &defect_, &scratch_.start}) field->reset(box);
  ratio_.reset();
}

template <class T>
IndexBox MomentGrid<T>::with_interpolated_ghosts(IndexBox box) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (rules_.side[axis][0] == SideRule::interpolated) --box.lo[axis];
    if (rules_.side[axis][1] == SideRule::interpolated) ++box.hi[axis];
  }
  return box;
}

template <class T>
void MomentGrid<T>::momentum(VectorField& g) const {
  for_each_row_in_order(g.box(), [&](int y, int z) {
    for (int c = 0; c < 3; ++c)
      std::copy_n(state_.now.row(kGx + c, y, z) + (g.box().lo[0] - box().lo[0]), g.box().size(0),
                  g.row(c, y, z));
  });
}

template class MomentGrid<float>;
template class MomentGrid<double>;

}  // namespace capstan
