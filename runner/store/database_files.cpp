#include "runner/store/database_files.hpp"

#include <sys/stat.h>

namespace capstan {

std::vector<std::filesystem::path> files_of_database(const std::filesystem::path& database) {
  return {database, database.string() + "-wal", database.string() + "-shm"};
}

DatabaseFiles::DatabaseFiles(const std::filesystem::path& database) {
  for (const std::filesystem::path& path : files_of_database(database)) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) files_.push_back({path, status.st_dev, status.st_ino});
  }
}

std::string DatabaseFiles::change() const {
  for (const File& file : files_) {
    struct stat status {};
    if (stat(file.path.c_str(), &status) != 0) return file.path.string() + " was removed";
    if (status.st_dev != file.device || status.st_ino != file.inode)
      return file.path.string() + " was replaced by another file";
  }
  return "";
}

}  // namespace capstan
