#pragma once
// Detects that the files of an open database were removed or replaced. A process that has them open would go
// on writing to files that no other process can open any more.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// The database, its write-ahead log (-wal) and the shared memory of the log (-shm), as far as they exist.
class DatabaseFiles {
 public:
  /// Remembers the files that are there now.
  explicit DatabaseFiles(const std::filesystem::path& database);

  /// Names a file that was removed or replaced since then, and says which of the two happened; "" if there is
  /// none.
  std::string change() const;

 private:
  struct File {
    std::filesystem::path path;
    dev_t device;
    ino_t inode;
  };
  std::vector<File> files_;
};

/// Paths of the database, its -wal and its -shm.
std::vector<std::filesystem::path> files_of_database(const std::filesystem::path& database);

}  // namespace capstan
