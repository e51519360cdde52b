#pragma once
// Finds the damaged checkpoints of cases that are still to be computed.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

struct DamagedCheckpoint {
  std::filesystem::path path;
  std::string reason;                       ///< "fails its checksum"
  std::filesystem::path resumes_from = {};  ///< the other checkpoint, if it is usable; else empty
};

/// Reads all checkpoints of queued, failed and cancelled cases completely. A user may have failed and
/// cancelled cases queued again. The checkpoints of running cases are not read, because their runs replace
/// them.
/// \param runs  the directory of the run directories
std::vector<DamagedCheckpoint> damaged_checkpoints(const std::filesystem::path& runs, Database& database);

}  // namespace capstan
