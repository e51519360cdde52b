#pragma once
// The two checkpoint files of a run: which of them can be resumed from, judged without reading the state.
#include <array>
#include <filesystem>
#include <string>

#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// One of the two files.
struct CheckpointFile {
  std::filesystem::path path;
  CheckpointHeader header = {};  ///< sequence 0 if the file is not usable
  std::string reason = {};       ///< why it is not usable; empty if it is, or if there is no file
  bool is_damaged = false;       ///< not usable by any program, because bytes are missing or wrong
  bool usable() const { return header.sequence > 0; }
};

/// Both files, the newer usable one first; if none is usable, b and then a, so that a run begins with a.
/// Reads only the headers.
/// \param numerics  the numerics version of the program that would resume
std::array<CheckpointFile, 2> checkpoint_files(const RunDirectory& directory, const std::string& steps_id,
                                               int numerics);

/// Removes the other one. If that cannot be done, only disk space is lost.
void keep_newest_checkpoint(const RunDirectory& directory, const std::string& steps_id, int numerics);

/// The same file after all of it was read: not usable if its checksum is wrong.
CheckpointFile with_checksum(CheckpointFile file);

}  // namespace capstan
