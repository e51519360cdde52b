#include "runner/service/data_directory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace capstan {

DataDirectory::DataDirectory(const std::filesystem::path& path) {
  std::filesystem::create_directories(path / "runs");
  path_ = std::filesystem::canonical(path);
  const std::filesystem::path file = path_ / "lock";
  lock_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) throw std::system_error(errno, std::generic_category(), "cannot open " + file.string());
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  close(lock_);
  throw std::runtime_error("another capstan serves " + path_.string() +
                           "; give this one its own --data directory");
}

DataDirectory::~DataDirectory() { close(lock_); }

}  // namespace capstan
