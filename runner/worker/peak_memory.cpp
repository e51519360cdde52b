#include "runner/worker/peak_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace capstan {

bool restart_peak_memory() {
  malloc_trim(0);  // gives back what earlier runs have freed
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;  // proc(5): resets the "high water mark"
  return file.good();
}

std::optional<double> peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;)
    if (double kilobytes = 0; key == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
  return std::nullopt;
}

}  // namespace capstan
