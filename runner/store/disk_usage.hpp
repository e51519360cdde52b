#pragma once
// What takes space in a data directory, study by study.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// Bytes on the disk.
struct RunUsage {
  std::uint64_t shapes = 0, checkpoints = 0, other = 0;
  std::uint64_t total() const { return shapes + checkpoints + other; }
  RunUsage& operator+=(const RunUsage& more);
};

struct StudyUsage {
  std::string study;
  int cases = 0;
  RunUsage runs;  ///< of all its cases, also of those that it shares with other studies
};

struct DiskUsage {
  std::vector<StudyUsage> studies;  ///< the largest first
  RunUsage without_study;           ///< run directories of cases that no study has
  RunUsage runs;                    ///< of all run directories, each once
  std::uint64_t database = 0;
};

/// Reads only. Throws std::runtime_error where there is no database that can be opened.
DiskUsage disk_usage(const std::filesystem::path& data);

}  // namespace capstan
