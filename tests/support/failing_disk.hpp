#pragma once
// A file system on a device of its own (ext4), for the time of a test, that can fail beneath whoever works on
// it.
#include <filesystem>

#include "tests/support/temporary_directory.hpp"

namespace capstan {

class FailingDisk {
 public:
  FailingDisk();
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  /// False where this user may not mount devices: then there is nothing to test with.
  bool is_mounted() const { return is_mounted_; }
  std::filesystem::path path() const { return directory_.path() / "disk"; }

  /// As the kernel does when the device has failed: what is written from now on is refused, also through
  /// files that are open, and all can still be read.
  void fail() const;
  /// Once nobody works on it any more.
  void repair();

 private:
  bool mount_image() const;

  TemporaryDirectory directory_;
  bool is_mounted_ = false;
};

/// Whether a file may be changed by anyone, also through what is open already.
void make_unchangeable(const std::filesystem::path& file, bool is_unchangeable);

}  // namespace capstan
