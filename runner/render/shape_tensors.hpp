#pragma once
// Shapes as arrays of bytes, in the layout of safetensors files (schema/shapes.md).
#include <span>
#include <string>
#include <vector>

#include "solver/run_directory/recorded_shapes.hpp"

namespace capstan {

/// Which part of a run's shapes the bytes hold.
struct ShapeRange {
  std::size_t first;          ///< index of the first shape
  std::size_t total;          ///< number of shapes of the run
  std::vector<double> times;  ///< kt of each shape in the bytes
};

/// \param shapes     one for each time; a field that one of them lacks is left out
/// \param triangles  #F x 3
std::string as_tensors(const ShapeRange& range, std::span<const ShapeArrays> shapes,
                       std::span<const int> triangles);

}  // namespace capstan
