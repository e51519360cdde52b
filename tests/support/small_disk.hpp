#pragma once
// A tmpfs of a given size for one test, visible to this process and its children only.
#include <filesystem>
#include <string>

#include "tests/support/temporary_directory.hpp"

namespace capstan {

class SmallDisk {
 public:
  /// \param size  option of tmpfs, such as "110m"
  explicit SmallDisk(const std::string& size);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  /// False if this user may not mount a tmpfs: then the test is to be skipped.
  bool is_mounted() const { return is_mounted_; }
  const std::filesystem::path& path() const { return directory_.path(); }

  void fill() const;   ///< writes a file until no byte is free
  void clear() const;  ///< removes that file
  void make_read_only(bool is_read_only) const;

 private:
  std::filesystem::path filler() const { return path() / "filler"; }

  TemporaryDirectory directory_;
  bool is_mounted_ = false;
};

}  // namespace capstan
