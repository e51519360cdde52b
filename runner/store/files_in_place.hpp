#pragma once
// Whether the files of an open database still stand where they were opened. Who removes them takes nothing
// from a process that has them open: it would go on writing into files that nobody can find again.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

class FilesInPlace {
 public:
  /// Of the database, its log (-wal) and the log's index (-shm), as far as they are there.
  explicit FilesInPlace(const std::filesystem::path& database);

  /// Which of them was removed or replaced, or "".
  std::string fault() const;

 private:
  struct File {
    std::filesystem::path path;
    dev_t device;
    ino_t number;
  };
  std::vector<File> files_;
};

}  // namespace capstan
