#pragma once
// The history of a run: history.jsonl, and its rows in the database.
#include <sys/types.h>

#include <filesystem>
#include <string>

#include "runner/store/database.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {

/// Follows one history.jsonl while its worker appends to it, or replaces it by that of a finer rung.
class HistoryTail {
 public:
  explicit HistoryTail(std::filesystem::path file) : file_(std::move(file)) {}

  struct News {
    std::size_t first = 0;  ///< number of the first record
    History records;
    bool begin_anew =
        false;  ///< the file is new or was replaced: the records take the place of all earlier ones
  };
  /// The records that were added since the last call. A line still being written waits for the next call.
  News read_new();

 private:
  std::filesystem::path file_;
  ino_t inode_ = 0;
  std::streamoff offset_ = 0;
  std::size_t size_ = 0;
};

/// The history.jsonl of a run that has ended.
struct HistoryFile {
  History records;          ///< up to the first line that is not a record
  std::string damage = {};  ///< why `records` is incomplete, such as "is missing"; empty if it is complete
};

/// Throws std::filesystem::filesystem_error if the file cannot be read now but perhaps later (is_shortage).
HistoryFile read_history(const std::filesystem::path& file);

/// The text of a history.jsonl. Observables that a record lacks are left out.
std::string history_lines(const History& records);

/// Writes records as number `first`, `first` + 1, .. of the case, and replaces those that have these numbers.
void store_history(Database& database, const std::string& case_id, std::size_t first, const History& records);

/// Replaces the records of the case by those of the file. If the file is damaged, the records that it has are
/// replaced and the others stay.
void store_history_file(Database& database, const std::string& case_id, const HistoryFile& file);

/// The records of a case, in the order of time. Observables that the database does not keep are NaN.
History stored_history(Database& database, const std::string& case_id);

}  // namespace capstan
