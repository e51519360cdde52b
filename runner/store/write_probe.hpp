#pragma once
// Detects that a disk accepts no writes any more. A disk that fails may become read-only at any moment, and
// access(2) does not report it.
#include <filesystem>
#include <string>

namespace capstan {

class WriteProbe {
 public:
  /// Opens a temporary file without a name (O_TMPFILE) in the directory.
  explicit WriteProbe(const std::filesystem::path& directory);
  ~WriteProbe();
  WriteProbe(const WriteProbe&) = delete;
  WriteProbe& operator=(const WriteProbe&) = delete;

  /// Writes one byte. Returns why that failed, or "". A full disk is no error here, nor is a file system
  /// without O_TMPFILE.
  std::string error() const;

 private:
  int file_;
  int open_error_;  ///< errno of opening the file, or 0
};

}  // namespace capstan
