#pragma once
// Checks everything that a daemon keeps in its data directory, and repairs what can be repaired without loss.
#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

/// One finding of the checks.
struct Finding {
  enum class Kind {
    error,     ///< not repaired
    repaired,  ///< was an error
    note,      ///< needs no repair: the next run copes with it
  };
  std::string what;  ///< for users
  Kind kind = Kind::error;
};

/// Checks the disk, the database and the run directories. Returns the findings; none if all is well. Throws
/// std::runtime_error if the directory holds no database, and DatabaseError if that cannot be opened.
/// \param repair  repairs what it finds; throws std::runtime_error if a daemon serves the directory
std::vector<Finding> examine(const std::filesystem::path& data, bool repair);

}  // namespace capstan
