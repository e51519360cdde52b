#pragma once
// Reads the shapes that a run has recorded (schema/run_directory.md), also of a run that goes on.
//
// Thread-safe: HDF5 may be called by one thread at a time, so a lock is held while a file is read. The files
// are complete whenever they are there. Failures are std::runtime_error with operation and file.
#include <vector>

#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// A shape in the index of the run.
struct RecordedShape {
  double kt;   ///< shear time
  int number;  ///< of its file: shapes/0007.h5 for 7
};

/// The arrays of one shape, row by row.
struct ShapeArrays {
  std::vector<double> positions;   ///< #V x 3, / a
  std::vector<double> velocities;  ///< #V x 3, / (a k)
  std::vector<double> forces;      ///< #V x 3, by the membrane on the fluid, / (mu_a k a^2)
  std::vector<double> stretches;   ///< #V, larger principal stretch; empty if the run recorded none
};

/// The shapes in the index, in the order of their times; none without an index.
std::vector<RecordedShape> recorded_shapes(const RunDirectory& run);

ShapeArrays read_shape(const RunDirectory& run, const RecordedShape& shape);

/// #F x 3: the vertices of each triangle, from 0, counter-clockwise seen from outside.
std::vector<int> read_triangles(const RunDirectory& run);

}  // namespace capstan
