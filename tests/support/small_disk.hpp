#pragma once
// A file system of a given size, for the time of a test, that only this process and its children see.
#include <filesystem>
#include <string>

#include "tests/support/temporary_directory.hpp"

namespace capstan {

class SmallDisk {
 public:
  /// \param size  as of tmpfs, "110m"
  explicit SmallDisk(const std::string& size);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  /// False where this user may not mount anything: then there is nothing to test with.
  bool is_mounted() const { return is_mounted_; }
  const std::filesystem::path& path() const { return directory_.path(); }

  void fill() const;   ///< to the last byte
  void clear() const;  ///< takes away what fill() has put there
  void make_read_only(bool is_read_only) const;

 private:
  std::filesystem::path filler() const { return path() / "filler"; }

  TemporaryDirectory directory_;
  bool is_mounted_ = false;
};

}  // namespace capstan
