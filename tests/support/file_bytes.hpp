#pragma once
// Reads and writes whole files as bytes.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace capstan {

inline std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

}  // namespace capstan
