#include "solver/fluid/quasisteady/grid.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "solver/fluid/quasisteady/convection.hpp"
#include "solver/fluid/quasisteady/intergrid.hpp"
#include "solver/grid/for_each_row.hpp"

namespace capstan {
namespace {

//                                                     rho gx gy gz
constexpr std::array<double, kMoments> kStateToCoarse = {2, 1, 1, 1};
constexpr std::array<double, kMoments> kStateToFine = {0.5, 1, 1, 1};
constexpr std::array<double, kMoments> kResidualToCoarse = {2, 4, 4, 4};

// Stresses are extrapolated almost to the new time: all the way costs the damping of their own errors from
// step to step, not at all leaves the first cycle an error twice as large (measured for V = 0.1 ... 10).
constexpr double kStressExtrapolation = 0.8;

/// P_xy of the undisturbed flow at rate 1: sum w_i e_x e_y 3 e_x (y - e_y dx).
double couette_stress(double dx) { return -dx / 3; }

/// Momentum of a field += factor * vectors.
template <class T>
void add_vectors(double factor, const VectorBox& vectors, RowField<T>& field) {
  vectors.for_each_row([&](int y, int z) {
    for (int c = 0; c < 3; ++c) {
      T* row = field.row(kGx + c, y, z) + (vectors.lo()[0] - field.box().lo[0]);
      for (int i = 0; i < vectors.size()[0]; ++i) row[i] += T(factor * vectors.row(c, y, z)[i]);
    }
  });
}

template <class T>
Strides strides_of(const RowField<T>& field) {
  return {field.component_stride(), field.y_stride(), field.z_stride()};
}

}  // namespace

template <class T>
Grid<T>::Grid(const IndexBox& box, const IndexBox& domain, const SideRules& domain_rules, double dx,
              double Re, bool has_stress, const Relaxation& relaxation)
    : domain_(domain),
      domain_rules_(domain_rules),
      dx_(dx),
      inertia_(Re * kAmbientViscosity * dx),
      relaxation_(relaxation),
      rules_(rules_of(box)),
      f_(box, kMoments),
      out_(box, kMoments),
      defect_(box, kMoments),
      start_(box, kMoments),
      before_(box, kMoments) {
  if (has_stress) stress_.emplace(box, rules_);
}

template <class T>
SideRules Grid<T>::rules_of(const IndexBox& box) const {
  SideRules rules = domain_rules_;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo[axis] != domain_.lo[axis]) rules.side[axis][0] = SideRule::interpolated;
    if (box.hi[axis] != domain_.hi[axis]) rules.side[axis][1] = SideRule::interpolated;
  }
  return rules;
}

// Every row is written by one thread from numbers that no thread changes: the result does not depend on their
// number.
template <class T>
void Grid<T>::sweep(double keep, double blend, double p_keep, double p_blend) {
  fill_ghosts(f_, rules_, kMomentParity);
  if (stress_) stress_->fill_ghosts();
  for_each_row(box(), [&](int y, int z) {
    const FluidRow<T> row{.m = f_.row(0, y, z),
                          .defect = defect_.row(0, y, z),
                          .out = out_.row(0, y, z),
                          .strides = strides_of(f_),
                          .count = box().size(0),
                          .keep = T(keep),
                          .blend = T(blend),
                          .shear = T(inertia_ * (y + 0.5) * dx_ / 2),
                          .lift = T(inertia_ * dx_)};
    if (!stress_ || !stress_->has(y, z)) return sweep_fluid(row);
    StressField<T>& s = *stress_;
    sweep_stress(StressRow<T>{.fluid = row,
                              .contrast = s.c.row(0, y, z),
                              .contrast_strides = strides_of(s.c),
                              .p = s.p.row(0, y, z),
                              .p_defect = s.defect.row(0, y, z),
                              .p_out = s.out.row(0, y, z),
                              .stress_strides = strides_of(s.p),
                              .p_keep = T(p_keep),
                              .p_blend = T(p_blend),
                              .undisturbed = T(couette_stress(dx_))});
  });
}

template <class T>
void Grid<T>::relax() {
  const double gamma = relaxation_.gamma[sweep_parity_];
  sweep_parity_ = 1 - sweep_parity_;
  sweep(1 - gamma, gamma, 1 - relaxation_.p, relaxation_.p);
  copy_interpolated(f_, out_, rules_);
  std::swap(f_, out_);
  if (stress_) std::swap(stress_->p, stress_->out);
}

template <class T>
void Grid<T>::restrict_to(Grid& coarse) {
  average_children(f_, coarse.f_, coarsened(box()), kStateToCoarse);
  if (stress_) stress_->restrict_to(*coarse.stress_);
  sweep_residual();
  coarse.take_defect(*this);
}

// Eq. 24: D = I m - S(I m) + I' r, where the whole stencil is covered; elsewhere the coarse grid keeps its
// own. With the old D in its residual r_H = S(I m) + D - I m, the new one is D - r_H + I' r.
template <class T>
void Grid<T>::take_defect(Grid& fine) {
  sweep_residual();
  const IndexBox inner = covered_stencils(fine);
  average_children(fine.out_, start_, inner, kResidualToCoarse);
  add_difference(start_, out_, defect_, inner);
  if (is_whole()) subtract_mean_mass_defect();
  if (stress_) stress_->take_defect(*fine.stress_);
  start_ = f_;
}

template <class T>
IndexBox Grid<T>::covered_stencils(const Grid& fine) const {
  IndexBox inner = coarsened(fine.box());
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.lo[axis] != domain_.lo[axis]) ++inner.lo[axis];
    if (inner.hi[axis] != domain_.hi[axis]) --inner.hi[axis];
  }
  return inner;
}

/// A domain without an outlet has a solution only if its sources of mass add up to none.
template <class T>
void Grid<T>::subtract_mean_mass_defect() {
  const IndexBox& cells = box();
  const auto for_each_mass_row = [&](auto visit) {  // in one order, so that the sum is always the same
    for (int z = cells.lo[2]; z < cells.hi[2]; ++z)
      for (int y = cells.lo[1]; y < cells.hi[1]; ++y) visit(defect_.row(kRho, y, z));
  };
  double sum = 0;
  for_each_mass_row([&](const T* row) {
    for (int i = 0; i < cells.size(0); ++i) sum += row[i];
  });
  const T mean = T(sum / double(cells.cells()));
  for_each_mass_row([&](T* row) {
    for (int i = 0; i < cells.size(0); ++i) row[i] -= mean;
  });
}

// Eq. 25.
template <class T>
void Grid<T>::correct_from(Grid& coarse) {
  coarse.take_change();
  add_linear(coarse.start_, f_, box(), kStateToFine);
  if (stress_) stress_->correct_from(*coarse.stress_);
  interpolate_ghosts(coarse);
}

/// start <- f - start, ghosts included.
template <class T>
void Grid<T>::take_change() {
  fill_ghosts(f_, rules_, kMomentParity);
  take_difference(f_.data(), start_.data());
  if (stress_) stress_->take_change();
}

template <class T>
void Grid<T>::interpolate_ghosts(const Grid& coarse) {
  const IndexBox all = with_interpolated_ghosts(box());
  IndexBox rest = all;  // without the layers that are done
  for (int axis = 0; axis < 3; ++axis) {
    IndexBox low = rest, high = rest;
    low.hi[axis] = rest.lo[axis] = box().lo[axis];
    high.lo[axis] = rest.hi[axis] = box().hi[axis];
    for (const IndexBox& layer : {low, high})
      if (layer.cells() > 0) interpolate(coarse.f_, f_, layer, kStateToFine);
  }
}

template <class T>
void Grid<T>::clear_force() {
  std::ranges::fill(defect_.data(), T(0));
  if (stress_) stress_->clear_defect();
}

template <class T>
void Grid<T>::add_force(const VectorBox& force) {
  add_vectors(1, force, defect_);
}

template <class T>
void Grid<T>::add_momentum(double factor, const VectorBox& force) {
  add_vectors(factor, force, f_);
}

template <class T>
void Grid<T>::add_convection() {
  if (inertia_ == 0) return;
  fill_ghosts(f_, rules_, kMomentParity);
  subtract_convection(f_, inertia_, defect_);
}

template <class T>
void Grid<T>::extrapolate(double weight) {
  capstan::extrapolate(f_.data(), before_.data(), weight);
  if (stress_) stress_->extrapolate(kStressExtrapolation * weight);
}

template <class T>
void Grid<T>::move_to(const IndexBox& box, Grid& coarse) {
  rules_ = rules_of(box);
  for (auto [fine, parents] : {std::pair{&f_, &coarse.f_}, std::pair{&before_, &coarse.before_}}) {
    fill_ghosts(*parents, coarse.rules_, kMomentParity);
    out_.reset(box);
    interpolate(*parents, out_, with_interpolated_ghosts(box), kStateToFine);
    copy_cells(*fine, out_);
    std::swap(*fine, out_);
  }
  for (RowField<T>* field : {&out_, &defect_, &start_}) field->reset(box);
  if (stress_) stress_->move_to(box, rules_);
}

template <class T>
IndexBox Grid<T>::with_interpolated_ghosts(IndexBox box) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (rules_.side[axis][0] == SideRule::interpolated) --box.lo[axis];
    if (rules_.side[axis][1] == SideRule::interpolated) ++box.hi[axis];
  }
  return box;
}

template <class T>
void Grid<T>::momentum(VectorBox& cells) const {
  cells.for_each_row([&](int y, int z) {
    for (int c = 0; c < 3; ++c)
      std::copy_n(f_.row(kGx + c, y, z) + (cells.lo()[0] - box().lo[0]), cells.size()[0], cells.row(c, y, z));
  });
}

template class Grid<float>;
template class Grid<double>;

}  // namespace capstan
