#include "runner/store/files_in_place.hpp"

#include <sys/stat.h>

namespace capstan {

FilesInPlace::FilesInPlace(const std::filesystem::path& database) {
  for (const char* ending : {"", "-wal", "-shm"}) {
    const std::string path = database.string() + ending;
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) files_.push_back({path, status.st_dev, status.st_ino});
  }
}

std::string FilesInPlace::fault() const {
  for (const File& file : files_) {
    struct stat status {};
    if (stat(file.path.c_str(), &status) != 0) return file.path.string() + " was removed";
    if (status.st_dev != file.device || status.st_ino != file.number)
      return file.path.string() + " was replaced by another file";
  }
  return "";
}

}  // namespace capstan
