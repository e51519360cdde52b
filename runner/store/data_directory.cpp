#include "runner/store/data_directory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <stdexcept>
#include <system_error>

namespace capstan {
namespace {

void expect_local_file_system(const std::filesystem::path& path) {
  struct statfs status {};
  if (statfs(path.c_str(), &status) != 0) return;
  const std::string name = network_file_system(status.f_type);
  if (!name.empty())
    throw std::runtime_error(path.string() + " lies on a network file system (" + name +
                             "), where a database cannot be kept safe; only its directory `runs` may, as a "
                             "symbolic link");
}

}  // namespace

void expect_data_directory(const std::filesystem::path& data) {
  if (!std::filesystem::exists(data / kDatabaseName))
    throw std::runtime_error(data.string() + " is no data directory: it holds no " + kDatabaseName);
}

std::string network_file_system(long type) {
  static const std::map<unsigned, std::string> kNames = {
      // linux/magic.h and the file systems' own headers
      {0x6969, "NFS"},        {0x517B, "SMB"},        {0xFF534D42, "CIFS"},  {0xFE534D42, "SMB2"},
      {0x00C36400, "Ceph"},   {0x0BD00BD0, "Lustre"}, {0x47504653, "GPFS"},  {0x5346414F, "AFS"},
      {0x19830326, "BeeGFS"}, {0x73757245, "Coda"},   {0x7461636F, "OCFS2"}, {0x01161970, "GFS2"}};
  const auto found = kNames.find(static_cast<unsigned>(type));
  return found == kNames.end() ? "" : found->second;
}

DataDirectory::DataDirectory(const std::filesystem::path& path) {
  std::filesystem::create_directories(path / kRunsName);
  path_ = std::filesystem::canonical(path);
  expect_local_file_system(path_);
  lock_ = open_locked(path_ / kDataLockName, O_RDWR | O_CREAT);
  try {
    directory_ = open_locked(path_, O_RDONLY | O_DIRECTORY);
  } catch (...) {
    close(lock_);
    throw;
  }
}

/// Opens a file and locks it. Returns its descriptor; closing that unlocks the file.
int DataDirectory::open_locked(const std::filesystem::path& path, int flags) const {
  const int descriptor = open(path.c_str(), flags | O_CLOEXEC, 0644);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), "cannot open " + path.string());
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  close(descriptor);
  throw std::runtime_error("another capstan serves " + path_.string() +
                           "; give this one its own --data directory");
}

DataDirectory::~DataDirectory() {
  close(directory_);
  close(lock_);
}

}  // namespace capstan
