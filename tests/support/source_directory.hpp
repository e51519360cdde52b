#pragma once
// The root of the sources, for tests that read reference data, schemas or READMEs.
#include <filesystem>

namespace capstan {

std::filesystem::path source_directory();

}  // namespace capstan
