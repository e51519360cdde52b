#pragma once
// The shapes of the membrane in time: one HDF5 file for each frame, one for the triangles, and an index of
// the frames with their times for ParaView.
//
// Each frame has its own file because HDF5 loses a whole file when its writer is killed. The index is
// replaced as a whole, in a time that grows with the number of frames: the caller decides when.
#include <filesystem>
#include <map>
#include <optional>

#include "solver/membrane/in_plane.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// The first of the frames 0 to count - 1 that cannot be read; nothing if all can be. A user may have removed
/// frames.
std::optional<std::filesystem::path> first_damaged_frame(const RunDirectory& directory, int count);

class ShapeWriter {
 public:
  /// Writes DIRECTORY/shapes/mesh.h5.
  /// \param membrane  with these faces; gives the stretches
  ShapeWriter(std::filesystem::path directory, const Faces& faces, InPlaneElasticity membrane);

  /// Writes DIRECTORY/shapes/NNNN.h5. Throws a std::runtime_error naming operation and file.
  /// \param kt          shear time
  /// \param frame       counts from 0
  /// \param positions   3 x #V, / a
  /// \param velocities  3 x #V, / (a k)
  /// \param forces      3 x #V, by the membrane on the fluid, / (mu_a k a^2)
  void write(double kt, int frame, const Points& positions, const Points& velocities, const Points& forces);

  /// Replaces the index DIRECTORY/shapes.xdmf2. It lists all frames up to the last one written; a resumed run
  /// writes the frames after its checkpoint again.
  void write_index() const;

 private:
  void take_up_frames_before(int frame);

  RunDirectory directory_;
  InPlaneElasticity membrane_;
  long face_count_, vertex_count_ = 0;
  std::map<int, double> times_;  ///< kt by frame
};

}  // namespace capstan
