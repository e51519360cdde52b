#include "tests/support/source_directory.hpp"

namespace capstan {

std::filesystem::path source_directory() { return CAPSTAN_SOURCE_DIR; }

}  // namespace capstan
