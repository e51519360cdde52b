#pragma once
// The text file that tells ParaView which arrays of which HDF5 files are the membrane at which time.
//
// XDMF version 2 (xdmf.org, "XDMF Model and Format"), in a file named *.xdmf2: ParaView 5.11 has two readers
// for
// *.xdmf and opens it with the one for version 3 unless told otherwise; for *.xdmf2 it has the one for
// version 2.
#include <string>
#include <vector>

namespace capstan {

/// One time of the collection. The frame file holds positions, velocities, forces: #V x 3 doubles.
struct XdmfFrame {
  double kt;
  std::string file;  ///< relative to the index
};

struct XdmfMesh {
  std::string file;  ///< holds faces: #F x 3 integers
  long vertex_count;
  long face_count;
};

std::string xdmf_index(const XdmfMesh& mesh, const std::vector<XdmfFrame>& frames);

}  // namespace capstan
