#pragma once
// Files that a command reads; "-" is standard input.
#include <filesystem>
#include <string>

namespace capstan {

/// Throws std::system_error when the file cannot be read.
std::string read_input(const std::filesystem::path& file);

/// The name for messages: its path, or "standard input".
std::string input_name(const std::filesystem::path& file);

}  // namespace capstan
