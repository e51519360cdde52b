#include "solver/output/shape_writer.hpp"

#include "solver/output/xdmf_index.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/hdf5_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

/// Writes a 3 x n matrix as n rows: column-major storage is the row-major storage of the transpose.
template <class Matrix>
void write_rows(Hdf5Writer& file, const std::string& name, const Matrix& matrix) {
  file.write(name, std::span(matrix.data(), static_cast<size_t>(matrix.size())), 3);
}

}  // namespace

std::optional<fs::path> first_damaged_frame(const RunDirectory& directory, int count) {
  for (int frame = 0; frame < count; ++frame) try {
      const fs::path path = directory.frame_file(frame);
      if (fs::exists(path)) Hdf5Reader(path).read("kt");
    } catch (const std::runtime_error&) {
      return directory.frame_file(frame);
    }
  return std::nullopt;
}

ShapeWriter::ShapeWriter(fs::path directory, const Faces& faces, InPlaneElasticity membrane)
    : directory_(std::move(directory)), membrane_(std::move(membrane)), face_count_(faces.cols()) {
  fs::create_directories(directory_.shapes_directory());
  PendingFile pending(directory_.mesh_file());
  Hdf5Writer mesh(pending.temporary());
  write_rows(mesh, "faces", faces);
  mesh.close();
  pending.publish();
}

void ShapeWriter::write(double kt, int frame, const Points& positions, const Points& velocities,
                        const Points& forces) {
  PendingFile pending(directory_.frame_file(frame));
  Hdf5Writer file(pending.temporary());
  file.write("kt", std::span(&kt, 1));
  write_rows(file, "positions", positions);
  write_rows(file, "velocities", velocities);
  write_rows(file, "forces", forces);
  const Scalars stretches = membrane_.vertex_stretches(positions);
  file.write("stretches", std::span(stretches.data(), static_cast<size_t>(stretches.size())));
  file.close();
  pending.publish();
  if (times_.empty()) take_up_frames_before(frame);
  times_[frame] = kt;
  vertex_count_ = positions.cols();
}

/// Adds the frames of earlier processes of this run to the index, without those that a user removed.
void ShapeWriter::take_up_frames_before(int frame) {
  for (int earlier = 0; earlier < frame; ++earlier) {
    const fs::path path = directory_.frame_file(earlier);
    if (fs::exists(path)) times_[earlier] = Hdf5Reader(path).read("kt").at(0);
  }
}

void ShapeWriter::write_index() const {
  const auto in_directory = [&](const fs::path& file) { return file.lexically_relative(directory_.path()); };
  std::vector<XdmfFrame> frames;
  for (const auto& [frame, kt] : times_) frames.push_back({kt, in_directory(directory_.frame_file(frame))});
  write_durably(directory_.shape_index_file(),
                xdmf_index({in_directory(directory_.mesh_file()), vertex_count_, face_count_}, frames));
}

}  // namespace capstan
