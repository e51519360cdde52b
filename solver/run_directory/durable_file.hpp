#pragma once
// Files that are there whole or not at all, whatever kills the process or the machine: written under a
// temporary name beside their target, synced, renamed over it, and the directory synced.
//
// It stands in solver/state, the bottom of the include order, because the worker's files (checkpoint, shapes,
// result) and the daemon's (case) are published the same way.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace capstan {

/// A file in the making. Whoever has filled `temporary()` and closed it calls `publish()`; without that the
/// target stays as it was. The temporary's name is fixed (target + ".partial"), so that what a killed process
/// leaves is overwritten by its successor: a target has one writer at a time.
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Throws std::filesystem::filesystem_error naming the operation and the file.
  void publish();

  /// The same without waiting for the disk: whole or not at all after a kill, but not after a power failure.
  void replace();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// The bytes of the file; nothing if there is none. Throws std::filesystem::filesystem_error where it is
/// there but cannot be read: that says nothing about what it holds.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// The error is the reader's own lack of descriptors or memory: later the same may succeed.
bool is_shortage(const std::filesystem::filesystem_error& error);

/// Replaces `path` by a file holding `bytes`. Throws std::filesystem::filesystem_error; the old file then
/// stands.
void write_durably(const std::filesystem::path& path, std::string_view bytes);

/// The same without waiting for the disk, for what can be made again.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace capstan
