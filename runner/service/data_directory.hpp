#pragma once
// The directory in which one daemon keeps everything.
#include <filesystem>
#include <string>

#include "runner/execute/run_directory.hpp"

namespace capstan {

class DataDirectory {
 public:
  /// Makes the directory if need be and holds it until the process ends. Throws std::runtime_error when
  /// another daemon holds it.
  explicit DataDirectory(const std::filesystem::path& path);
  ~DataDirectory();
  DataDirectory(const DataDirectory&) = delete;
  DataDirectory& operator=(const DataDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path database() const { return path_ / "capstan.sqlite"; }
  RunDirectory run(const std::string& case_id) const { return RunDirectory(path_ / "runs" / case_id); }

 private:
  std::filesystem::path path_;
  int lock_;
};

}  // namespace capstan
