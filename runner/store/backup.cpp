#include "runner/store/backup.hpp"

#include <stdexcept>

#include "runner/store/database.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::invalid_argument(file.string() + " " + why + ": choose another file for the copy");
}

/// The database with its log and index, the lock, the request log, the runs.
bool is_name_in_a_data_directory(const std::string& name) {
  return name.starts_with("capstan.sqlite") || name.starts_with("requests.log") || name == "lock" ||
         name == "runs";
}

bool is_data_directory(const fs::path& directory) {
  return fs::exists(directory / "lock") && fs::exists(directory / "runs");
}

/// A database of Capstan that nobody has open.
bool is_earlier_copy(const fs::path& file) try {
  if (fs::exists(file.string() + "-wal")) return false;
  Database copy(file, Database::Access::read);
  copy.query("SELECT 1 FROM studies JOIN cases").step();
  return true;
} catch (const DatabaseError&) {
  return false;
}

void refuse_wrong_target(const fs::path& data, const fs::path& file) {
  const fs::path directory = fs::absolute(file).parent_path();
  if (!fs::is_directory(directory))
    refuse(file, "cannot be written, as " + directory.string() + " is no directory");
  const bool is_needed = fs::equivalent(directory, data) || is_data_directory(directory);
  if (is_needed && is_name_in_a_data_directory(file.filename())) refuse(file, "belongs to a data directory");
  const fs::file_status status = fs::symlink_status(file);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse(file, "is no regular file");
  if (fs::equivalent(file, data / "capstan.sqlite")) refuse(file, "is the database itself");
  if (!is_earlier_copy(file)) refuse(file, "is there already and is no earlier copy of a database");
}

}  // namespace

void back_up_database(const fs::path& data, const fs::path& file) {
  Database database(data / "capstan.sqlite", Database::Access::read);
  refuse_wrong_target(data, file);
  database.copy_to(file);
}

}  // namespace capstan
