#pragma once
// The history of a run: what history.jsonl says, and its rows in the database.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "runner/queue/database.hpp"

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

/// Writes records as number `first` and on, over what stands there.
void store_history(Database& database, const std::string& case_id, std::size_t first,
                   const std::vector<HistoryRecord>& records);

/// Drops the records from number `first` on.
void cut_history(Database& database, const std::string& case_id, std::size_t first);

}  // namespace capstan
