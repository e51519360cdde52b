#pragma once
// Looks at everything that a daemon keeps, and mends what can be mended without losing anything.
#include <filesystem>
#include <string>
#include <vector>

namespace capstan {

struct Finding {
  enum class Kind {
    fault,
    mended,
    note,  ///< nothing is to be done: the next run finds its way
  };
  std::string what;
  Kind kind = Kind::fault;
};

/// Faults of the database, of the run directories and of the disk; none if all is well. Throws
/// std::runtime_error where there is no database that can be opened.
/// \param mend  and then no daemon may serve the directory: throws std::runtime_error if one does
std::vector<Finding> examine(const std::filesystem::path& data, bool mend);

}  // namespace capstan
