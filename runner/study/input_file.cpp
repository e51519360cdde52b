#include "runner/study/input_file.hpp"

#include <cerrno>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace capstan {
namespace {

bool is_standard_input(const std::filesystem::path& file) { return file == "-"; }

}  // namespace

std::string read_input(const std::filesystem::path& file) {
  if (is_standard_input(file)) return {std::istreambuf_iterator<char>(std::cin), {}};
  if (std::filesystem::is_directory(file))
    throw std::system_error(EISDIR, std::generic_category(), "cannot read " + file.string());
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::system_error(errno, std::generic_category(), "cannot read " + file.string());
  return text;
}

std::string input_name(const std::filesystem::path& file) {
  return is_standard_input(file) ? "standard input" : file.string();
}

}  // namespace capstan
