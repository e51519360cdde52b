#pragma once
// The history of a run: what history.jsonl says, and its rows in the database.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// The columns that are kept, by their names in history.jsonl; kt comes first.
inline constexpr std::array<const char*, 6> kHistoryColumns = {"kt",  "D_xy",   "theta",
                                                               "psi", "volume", "area"};

/// One recorded time; NaN where the file has no number.
using HistoryRecord = std::array<double, kHistoryColumns.size()>;

/// Follows one history.jsonl while its worker appends to it.
class HistoryTail {
 public:
  explicit HistoryTail(std::filesystem::path file) : file_(std::move(file)) {}

  /// The records that were added since the last call. A line still being written waits for the next call.
  std::vector<HistoryRecord> read_new();

  /// Number of records returned so far.
  std::size_t size() const { return size_; }

 private:
  std::filesystem::path file_;
  std::streamoff offset_ = 0;
  std::size_t size_ = 0;
};

/// A history.jsonl whose run has ended.
struct HistoryFile {
  std::vector<HistoryRecord> records;  ///< up to the first line that is none
  std::string fault = {};              ///< why that is not all; "" if it is
};

/// Throws std::filesystem::filesystem_error where the file can be read later (is_shortage).
HistoryFile read_history(const std::filesystem::path& file);

/// The lines of a history.jsonl with the columns that are kept.
std::string history_lines(const std::vector<HistoryRecord>& records);

/// Writes records as number `first` and on, over what stands there.
void store_history(Database& database, const std::string& case_id, std::size_t first,
                   const std::vector<HistoryRecord>& records);

/// The case's records are those of the file from now on. Of a file that is not whole only its records are
/// taken, and the others stay as they are.
void store_history_file(Database& database, const std::string& case_id, const HistoryFile& file);

/// The records of a case, in their order.
std::vector<HistoryRecord> stored_history(Database& database, const std::string& case_id);

}  // namespace capstan
