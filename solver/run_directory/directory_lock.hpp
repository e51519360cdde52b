#pragma once
// The right to work in a run directory: a lock of the kernel (flock) on its file `lock`. The daemon takes it
// and leaves it to the process that it starts; a process that a user starts takes it itself. The kernel takes
// it back when the last process that has it ends: no record of ours can be wrong about that, whoever was
// killed when.
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

class DirectoryLock {
 public:
  /// Where the daemon leaves it to the process that it starts.
  static constexpr int kInheritedDescriptor = 3;

  /// Throws a std::system_error naming the file, which is made if it is not there.
  explicit DirectoryLock(const RunDirectory& directory);

  /// The one that this process was started with, if it is of this directory; else a new one.
  static DirectoryLock inherited_or_new(const RunDirectory& directory);

  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// False while another process has it.
  bool take();
  int descriptor() const { return descriptor_; }

 private:
  explicit DirectoryLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace capstan
