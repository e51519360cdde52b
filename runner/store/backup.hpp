#pragma once
// A copy of the database, also of a running daemon's.
#include <filesystem>

namespace capstan {

/// Copies the database of a data directory into the file, which is replaced whole or not at all. Throws
/// std::invalid_argument where the file may not be replaced: it is neither missing nor an earlier copy, or a
/// data directory needs it.
void back_up_database(const std::filesystem::path& data, const std::filesystem::path& file);

}  // namespace capstan
