#include "tests/support/failing_disk.hpp"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "tests/support/own_mounts.hpp"

namespace capstan {
namespace {

bool shell(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

}  // namespace

FailingDisk::FailingDisk() {
  const std::string image = directory_.path() / "image";
  std::filesystem::create_directory(path());
  is_mounted_ = enter_mount_namespace() && shell("truncate -s 300M " + image) &&
                shell("PATH=$PATH:/sbin mkfs.ext4 -q " + image) && mount_image();
}

FailingDisk::~FailingDisk() {
  if (is_mounted_) umount2(path().c_str(), MNT_DETACH);
}

bool FailingDisk::mount_image() const {
  return shell("mount -o loop,errors=remount-ro " + (directory_.path() / "image").string() + " " +
               path().string());
}

/// Writes all dirty pages first: otherwise reads from memory would hide the failure.
void FailingDisk::fail() const {
  sync();
  mount("none", path().c_str(), nullptr, MS_REMOUNT, "abort");
}

void FailingDisk::repair() {
  umount2(path().c_str(), 0);
  is_mounted_ = mount_image();
}

void make_unchangeable(const std::filesystem::path& file, bool is_unchangeable) {
  const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  int flags = 0;
  ioctl(opened, FS_IOC_GETFLAGS, &flags);
  flags = is_unchangeable ? flags | FS_IMMUTABLE_FL : flags & ~FS_IMMUTABLE_FL;
  ioctl(opened, FS_IOC_SETFLAGS, &flags);
  close(opened);
}

}  // namespace capstan
