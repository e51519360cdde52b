#include "runner/worker/standard_method.hpp"

#include <cmath>

#include "solver/case/units.hpp"

namespace capstan {
namespace {

constexpr double kRe = 0.05, kDx = 0.1;
constexpr int kCells = 128;  // along an edge

}  // namespace

double StandardMethod::seconds(double kt) const {
  return kt / kdt * std::pow(double(kCells), 3) / speed.updates;
}

StandardMethod standard_method_of_paper() {
  return {kernel_speed<double>(Kernel::nineteen_populations, {kCells, kCells, kCells}),
          lattice_units(kRe, kTransientViscosity, kDx).kdt};
}

StandardMethod standard_method_at_its_best() {
  return {kernel_speed<double>(Kernel::four_moments, {kCells, kCells, kCells}),
          lattice_units(kRe, 1. / 6, kDx).kdt};
}

}  // namespace capstan
