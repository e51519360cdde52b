#pragma once
// Replacing a file as a whole: after a kill or a power failure the old content or the new one is there, never
// a part of it. The new content is written to a temporary file beside the target and synced; the temporary is
// renamed to the target, and the directory is synced.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace capstan {

/// Extension of the temporary files.
inline constexpr const char* kPartialExtension = ".partial";

/// A file that is being written. The caller fills and closes `temporary()`, then calls `publish()`; without
/// that the target keeps its old content. A target has one writer at a time: a process of an earlier attempt
/// has temporary files of its own, and cannot replace the target (attempt_token.hpp).
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Replaces the target durably. Throws std::filesystem::filesystem_error naming the operation and the file,
  /// or AttemptWithdrawn.
  void publish();

  /// Replaces the target without waiting for the disk: safe if the process is killed, but not in a power
  /// failure.
  void replace();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// The content of the file; nothing if there is no such file. Throws std::filesystem::filesystem_error where
/// the file is there but cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// True if this process lacked descriptors or memory: the same operation may succeed later.
bool is_shortage(const std::filesystem::filesystem_error& error);

/// Replaces the content of `path`, durably. Throws std::filesystem::filesystem_error; then the file keeps its
/// old content.
void write_durably(const std::filesystem::path& path, std::string_view bytes);

/// The same without waiting for the disk, for files that can be written again.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Makes a file appear under another name, too, unless that name is taken: a hard link, or a copy on a file
/// system without links. As files are only ever replaced as a whole, neither name changes the other's
/// content.
void link_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// The same for all files of a folder. Makes the other folder if it is not there.
void link_files(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace capstan
