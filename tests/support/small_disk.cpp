#include "tests/support/small_disk.hpp"

#include <fcntl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "tests/support/own_mounts.hpp"

namespace capstan {

SmallDisk::SmallDisk(const std::string& size) {
  is_mounted_ =
      enter_mount_namespace() && mount("none", path().c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
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
