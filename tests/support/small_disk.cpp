#include "tests/support/small_disk.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>
#include <vector>

namespace capstan {
namespace {

/// Mounts of this process are seen by nobody else. A user without rights has them in a namespace of its own.
bool enter_own_namespace() {
  const uid_t user = getuid();
  const gid_t group = getgid();
  if (unshare(CLONE_NEWNS) != 0) {
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  }
  return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

}  // namespace

SmallDisk::SmallDisk(const std::string& size) {
  is_mounted_ =
      enter_own_namespace() && mount("none", path().c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
}

SmallDisk::~SmallDisk() {
  if (is_mounted_) umount2(path().c_str(), MNT_DETACH);
}

void SmallDisk::fill() const {
  const int file = open(filler().c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  for (std::vector<char> block(1 << 20); !block.empty();)
    if (write(file, block.data(), block.size()) <= 0) block.resize(block.size() / 2);
  close(file);
}

void SmallDisk::clear() const { std::filesystem::remove(filler()); }

void SmallDisk::make_read_only(bool is_read_only) const {
  mount("none", path().c_str(), nullptr, is_read_only ? MS_REMOUNT | MS_RDONLY : MS_REMOUNT + 0UL, nullptr);
}

}  // namespace capstan
