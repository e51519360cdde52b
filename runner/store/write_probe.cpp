#include "runner/store/write_probe.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace capstan {

WriteProbe::WriteProbe(const std::filesystem::path& directory)
    : file_(open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600)),
      open_error_(file_ < 0 ? errno : 0) {}

WriteProbe::~WriteProbe() {
  if (file_ >= 0) close(file_);
}

std::string WriteProbe::error() const {
  int error = open_error_;
  if (file_ >= 0 && pwrite(file_, "", 1, 0) != 1) error = errno;
  for (const int harmless : {0, ENOSPC, EDQUOT, EOPNOTSUPP, EISDIR})
    if (error == harmless) return "";
  return std::generic_category().message(error);
}

}  // namespace capstan
