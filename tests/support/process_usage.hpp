#pragma once
// Memory and open files of a process, from /proc.
#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace capstan {

inline double resident_mb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  constexpr std::string_view kName = "VmRSS:";
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(kName)) return std::stod(line.substr(kName.size())) / 1024;
  return 0;
}

inline long open_files(pid_t pid) {
  const std::filesystem::directory_iterator files("/proc/" + std::to_string(pid) + "/fd");
  return std::distance(begin(files), end(files));
}

}  // namespace capstan
