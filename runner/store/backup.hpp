#pragma once
// A backup of the database, also while a daemon writes to it.
#include <filesystem>

namespace capstan {

/// Copies the database of a data directory into the file: a consistent snapshot, which is checked before it
/// replaces an earlier backup. Throws std::invalid_argument if the file exists and is no backup, or if its
/// name is one that a data directory uses for its own files.
void back_up_database(const std::filesystem::path& data, const std::filesystem::path& file);

}  // namespace capstan
