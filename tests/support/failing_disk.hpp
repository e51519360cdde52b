#pragma once
// A file system (ext4 in a loop device) for one test, whose device can be made to fail while it is mounted.
#include <filesystem>

#include "tests/support/temporary_directory.hpp"

namespace capstan {

class FailingDisk {
 public:
  FailingDisk();
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  /// False if this user may not mount devices: then the test is to be skipped.
  bool is_mounted() const { return is_mounted_; }
  std::filesystem::path path() const { return directory_.path() / "disk"; }

  /// Brings the file system into the state after an error of the device: every write fails from now on, also
  /// to open files. Reading still works.
  void fail() const;
  /// Mounts it again. No file of it may be open.
  void repair();

 private:
  bool mount_image() const;

  TemporaryDirectory directory_;
  bool is_mounted_ = false;
};

/// Sets or clears the immutable flag of a file (chattr +i): nobody can write to it, also not through open
/// descriptors.
void make_unchangeable(const std::filesystem::path& file, bool is_unchangeable);

}  // namespace capstan
