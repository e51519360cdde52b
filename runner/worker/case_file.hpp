#pragma once
// Reads the file of a case; "-" is standard input.
#include <filesystem>

#include "solver/case/parse.hpp"

namespace capstan {

/// The case, or all its issues; a study file is refused with an issue. Throws std::system_error if the file
/// cannot be read.
ParsedCase read_case(const std::filesystem::path& path);

/// Prints one line for each issue to standard error.
void print_case_issues(const std::filesystem::path& file, const Issues& issues);

}  // namespace capstan
