#pragma once
// A case from its file; "-" is standard input.
#include <filesystem>

#include "solver/case/parse.hpp"

namespace capstan {

/// The case, or all that is wrong with it. Throws std::system_error when the file cannot be read.
ParsedCase read_case(const std::filesystem::path& path);

/// One line each, to standard error.
void print_faults(const std::filesystem::path& file, const Issues& issues);

}  // namespace capstan
