#pragma once
// The index of the shapes for ParaView: for each time, the HDF5 files and arrays that hold the membrane.
//
// XDMF version 2 (xdmf.org, "XDMF Model and Format"), in a file named *.xdmf2. ParaView 5.11 opens *.xdmf
// with its reader for version 3, and *.xdmf2 with the one for version 2.
#include <string>
#include <vector>

namespace capstan {

/// The membrane at one time. The frame file holds positions, velocities and forces, each #V x 3 doubles.
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
