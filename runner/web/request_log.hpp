#pragma once
// A line a request, in a file that cannot fill the disk.
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>

namespace capstan {

class RequestLog {
 public:
  /// \param most  bytes: beyond, the file becomes FILE.1 and a new one is begun
  explicit RequestLog(std::filesystem::path file, std::size_t most = 16 << 20);

  /// From any thread. Characters that would break a line or a terminal are replaced.
  void write(const std::string& line);
  /// Goes on in the file of that name, whatever has become of the one that was open.
  void reopen();

 private:
  std::filesystem::path file_;
  const std::size_t most_;
  std::mutex mutex_;
  std::ofstream stream_;
};

}  // namespace capstan
