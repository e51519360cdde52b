#pragma once
// The two files in which a run keeps its state in turn, judged without reading the state.
#include <array>
#include <filesystem>
#include <string>

#include "solver/run_directory/checkpoint_header.hpp"

namespace capstan {

/// One of the two.
struct CheckpointFile {
  std::filesystem::path path;
  CheckpointHeader header = {};  ///< sequence 0 when it is not usable
  std::string fault = {};        ///< why it is not usable; empty when it is, or when there is no file
  bool is_damaged = false;       ///< the fault is one of the bytes: this file is of no use to anyone
  bool usable() const { return header.sequence > 0; }
};

/// Both, the newer usable one first; of two unusable ones b, so that a run begins with a. Judged by their
/// headers alone.
/// \param numerics  the numerics version of the program that wants to go on from one of them
std::array<CheckpointFile, 2> checkpoint_files(const std::filesystem::path& run, const std::string& case_id,
                                               int numerics);

/// The same file, read as a whole: a wrong checksum is a fault, too.
CheckpointFile with_checksum(CheckpointFile file);

}  // namespace capstan
