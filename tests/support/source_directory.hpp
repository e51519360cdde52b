#pragma once
// Where the sources are that a test reads: reference data, schemas, READMEs.
#include <filesystem>

namespace capstan {

std::filesystem::path source_directory();

}  // namespace capstan
