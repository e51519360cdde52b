#pragma once
// The space that a data directory takes on the disk, by study.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// Bytes that a run directory takes on the disk (allocated blocks).
struct RunBytes {
  std::uint64_t shapes = 0, checkpoints = 0, other = 0;
  std::uint64_t total() const { return shapes + checkpoints + other; }
  RunBytes& operator+=(const RunBytes& more);
};

struct StudyUsage {
  std::string study;
  int cases = 0;
  RunBytes runs;  ///< of all its cases, including those shared with other studies
};

struct DiskUsage {
  std::vector<StudyUsage> studies;  ///< sorted by size, the largest first
  RunBytes without_study;           ///< run directories whose case is in no study
  RunBytes runs;                    ///< of all run directories, each counted once
  std::uint64_t database = 0;
};

/// Throws std::runtime_error if the directory holds no database, and DatabaseError if that cannot be opened.
DiskUsage disk_usage(const std::filesystem::path& data);

}  // namespace capstan
