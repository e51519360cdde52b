// The computation of each observable: one function for each row of kObservables.
#include "solver/observe/measure.hpp"

#include <utility>

#include "solver/mesh/geometry.hpp"

namespace capstan {
namespace {

/// The observable in the unit of its row. A row without its function does not compile, nor does a function
/// without its row.
template <ObservableRow row>
double measure(const Snapshot&) = delete;

template <>
double measure<"kt">(const Snapshot& now) {
  return now.motion.kt;
}

template <>
double measure<"D_xy">(const Snapshot& now) {
  return now.motion.D_xy;
}

template <>
double measure<"theta">(const Snapshot& now) {
  return now.motion.theta;
}

template <>
double measure<"psi">(const Snapshot& now) {
  return now.motion.psi;
}

template <>
double measure<"volume">(const Snapshot& now) {
  return volume(now.positions, now.mesh.faces);
}

template <>
double measure<"area">(const Snapshot& now) {
  return area(now.positions, now.mesh.faces);
}

template <>
double measure<"iterations">(const Snapshot& now) {
  return now.iterations;
}

template <>
double measure<"error">(const Snapshot& now) {
  return now.flow_error;
}

template <std::size_t... row>
Record measure_rows(const Snapshot& snapshot, std::index_sequence<row...>) {
  Record record;
  ((record.values[row] = measure<ObservableRow(row)>(snapshot)), ...);
  return record;
}

}  // namespace

Record measure_all(const Snapshot& snapshot) {
  return measure_rows(snapshot, std::make_index_sequence<kObservableCount>());
}

}  // namespace capstan
