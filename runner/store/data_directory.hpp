#pragma once
// The directory in which one daemon keeps everything.
#include <filesystem>
#include <string>

#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// With less left on the disk no more is promised.
inline constexpr std::uintmax_t kMinFree = 100'000'000;  // bytes

/// Its name, if statfs(2)'s f_type is that of a network file system, or "".
std::string network_file_system(long type);

class DataDirectory {
 public:
  /// Makes the directory if need be and holds it until the process ends, whoever removes the file `lock`.
  /// Throws std::runtime_error when another daemon holds it, or when it lies on a network file system:
  /// SQLite's log cannot be kept there. Only `runs` may, as a symbolic link.
  explicit DataDirectory(const std::filesystem::path& path);
  ~DataDirectory();
  DataDirectory(const DataDirectory&) = delete;
  DataDirectory& operator=(const DataDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path database() const { return path_ / "capstan.sqlite"; }
  std::filesystem::path runs() const { return path_ / "runs"; }
  RunDirectory run(const std::string& case_id) const { return RunDirectory(runs() / case_id); }

 private:
  int held(const std::filesystem::path& path, int flags) const;

  std::filesystem::path path_;
  int lock_ = -1, directory_ = -1;
};

}  // namespace capstan
