#pragma once
// Exclusive access to a run directory: a lock of the kernel (flock) on the file `lock` in it.
//
// The daemon takes the lock before it starts a process and passes it on to that process; a process that a
// user starts takes the lock itself. The kernel releases it when the last process that holds it ends, however
// that process ended.
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

class DirectoryLock {
 public:
  /// The descriptor under which a process finds the lock that the daemon passed on.
  static constexpr int kInheritedDescriptor = 3;

  /// Opens the lock file, and makes it if it is missing; does not lock yet. Throws std::system_error naming
  /// the file.
  explicit DirectoryLock(const RunDirectory& directory);

  /// The lock that the daemon passed on to this process, if it belongs to this directory; else a new one.
  static DirectoryLock inherited_or_new(const RunDirectory& directory);

  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// Locks without waiting; false while another process holds the lock.
  bool take();
  int descriptor() const { return descriptor_; }

 private:
  explicit DirectoryLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace capstan
