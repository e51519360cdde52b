#pragma once
// The directory in which one daemon keeps its database, its run directories and its request log.
#include <filesystem>
#include <string>

#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// With less free space than this no run is started, the service is not ready, and `capstan doctor` reports
/// the disk.
inline constexpr std::uintmax_t kMinFree = 100'000'000;  // bytes

// Names in a data directory.
inline constexpr const char* kDatabaseName = "capstan.sqlite";
inline constexpr const char* kRunsName = "runs";
inline constexpr const char* kDataLockName = "lock";

/// Throws std::runtime_error if the directory holds no database.
void expect_data_directory(const std::filesystem::path& data);

/// The name of a network file system, given f_type of statfs(2); "" for any other file system.
std::string network_file_system(long type);

/// Locks the directory for this process, so that no second daemon uses it.
class DataDirectory {
 public:
  /// Makes the directory if it is missing. Both the file `lock` and the directory itself are locked, as a
  /// user may remove the file. Throws std::runtime_error if another daemon holds the lock, or if the
  /// directory is on a network file system, where SQLite's write-ahead log does not work. Only `runs` may be
  /// on such a file system, through a symbolic link.
  explicit DataDirectory(const std::filesystem::path& path);
  ~DataDirectory();
  DataDirectory(const DataDirectory&) = delete;
  DataDirectory& operator=(const DataDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path database() const { return path_ / kDatabaseName; }
  std::filesystem::path runs() const { return path_ / kRunsName; }
  RunDirectory run(const std::string& case_id) const { return RunDirectory(runs() / case_id); }

 private:
  int open_locked(const std::filesystem::path& path, int flags) const;

  std::filesystem::path path_;
  int lock_ = -1, directory_ = -1;  ///< descriptors; the locks last until they are closed
};

}  // namespace capstan
