#pragma once
// A log with one line a request. Its files are limited in size.
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>

namespace capstan {

class RequestLog {
 public:
  /// \param max_bytes  a file of that size is renamed to FILE.1, replacing the one before, and a new one is
  /// begun
  explicit RequestLog(std::filesystem::path file, std::size_t max_bytes = 16 << 20);

  /// From any thread. Replaces characters that could break the line or control a terminal.
  void write(const std::string& line);
  /// Closes the file and opens the one that has its name now (log rotation).
  void reopen();

 private:
  const std::filesystem::path file_;
  const std::size_t max_bytes_;
  std::mutex mutex_;
  std::ofstream stream_;
};

}  // namespace capstan
