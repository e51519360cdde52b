#pragma once
// One shape of a capsule as a file for other programs, and shapes as arrays of bytes.
#include <string>
#include <vector>

#include "solver/run_directory/recorded_shapes.hpp"

namespace capstan {

/// A shape with its triangles, in the arrays of recorded_shapes.hpp.
struct TriangulatedShape {
  double kt;
  ShapeArrays arrays;
  std::vector<int> triangles;
};

/// VTK's XML PolyData in text, with the fields velocity, force and stretch: for ParaView and PyVista.
std::string as_vtp(const TriangulatedShape& shape);

/// Binary STL: the triangles alone, in single precision.
std::string as_stl(const TriangulatedShape& shape);

/// Wavefront OBJ: vertices and triangles in text.
std::string as_obj(const TriangulatedShape& shape);

/// A ParaView collection: the index of files that hold one time each.
struct TimeAndFile {
  double kt;
  std::string file;  ///< relative to the collection
};
std::string as_pvd(const std::vector<TimeAndFile>& files);

}  // namespace capstan
