#include "solver/run_directory/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace capstan {
namespace {

bool is_open_as(int descriptor, const std::filesystem::path& path) {
  struct stat open_file, named_file;
  return fstat(descriptor, &open_file) == 0 && stat(path.c_str(), &named_file) == 0 &&
         open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

}  // namespace

DirectoryLock::DirectoryLock(const RunDirectory& directory)
    : descriptor_(open(directory.lock_file().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0)
    throw std::system_error(errno, std::generic_category(), "cannot open " + directory.lock_file().string());
}

DirectoryLock DirectoryLock::inherited_or_new(const RunDirectory& directory) {
  if (is_open_as(kInheritedDescriptor, directory.lock_file())) return DirectoryLock(kInheritedDescriptor);
  return DirectoryLock(directory);
}

DirectoryLock::~DirectoryLock() { close(descriptor_); }

bool DirectoryLock::take() { return flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

}  // namespace capstan
