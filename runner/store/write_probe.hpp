#pragma once
// Whether a disk still takes what is written to it. One that has failed turns read-only from one moment to
// the next, and who only asks for the right to write is not told.
#include <filesystem>
#include <string>

namespace capstan {

class WriteProbe {
 public:
  /// Opens a file without a name in the directory.
  explicit WriteProbe(const std::filesystem::path& directory);
  ~WriteProbe();
  WriteProbe(const WriteProbe&) = delete;
  WriteProbe& operator=(const WriteProbe&) = delete;

  /// Why nothing can be written, or "": also where the disk is full, and where it has no files without names.
  std::string fault() const;

 private:
  int file_;
  int error_;  ///< of opening it
};

}  // namespace capstan
