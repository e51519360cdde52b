#pragma once
// Whether the runs that are to go on can do so.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// A checkpoint that nobody can read any more.
struct DamagedCheckpoint {
  std::filesystem::path path;
  std::string fault;
  std::filesystem::path other = {};  ///< what the case goes on from instead; empty if it starts anew
};

/// Reads the checkpoints of all cases that are yet to be computed, whole. Those of running ones are left
/// alone: they are being replaced.
/// \param runs  the directory of the run directories
std::vector<DamagedCheckpoint> damaged_checkpoints(const std::filesystem::path& runs, Database& database);

}  // namespace capstan
