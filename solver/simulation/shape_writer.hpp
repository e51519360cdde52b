#pragma once
// The membrane in time: one HDF5 file a frame, the triangles in one of their own, and an index of the frames
// with their times for ParaView.
//
// One file a frame, because HDF5 loses a whole file when its writer is killed. Each is published whole, and
// the index after it.
#include <filesystem>
#include <map>

#include "solver/mesh/triangle_mesh.hpp"

namespace capstan {

class ShapeWriter {
 public:
  /// Writes DIRECTORY/shapes/mesh.h5.
  ShapeWriter(std::filesystem::path directory, const Faces& faces);

  /// Writes DIRECTORY/shapes/NNNN.h5, and the index DIRECTORY/shapes.xdmf2 of this and all earlier frames: a
  /// resumed run drops the frames after its checkpoint from the index, and writes them again.
  /// Throws a std::runtime_error naming operation and file.
  /// \param kt          shear time
  /// \param frame       counts from 0
  /// \param positions   3 x #V, / a
  /// \param velocities  3 x #V, / (a k)
  /// \param forces      3 x #V, by the membrane on the fluid, / (mu_a k a^2)
  void write(double kt, int frame, const Points& positions, const Points& velocities, const Points& forces);

 private:
  void take_up_frames_before(int frame);
  void write_index(long vertex_count) const;

  std::filesystem::path directory_;
  long face_count_;
  std::map<int, double> times_;  ///< kt by frame
};

}  // namespace capstan
