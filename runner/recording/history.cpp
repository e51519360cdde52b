#include "runner/recording/history.hpp"

#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "runner/store/history_columns.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

/// Parameters: the case, the number of the record, then the values in the order of the columns.
std::string insertion() {
  std::string names = "case_id, record", parameters = "?, ?";
  for (const std::string& name : history_columns()) {
    names += ", " + name;
    parameters += ", ?";
  }
  return "INSERT OR REPLACE INTO histories (" + names + ") VALUES (" + parameters + ")";
}

void store_record(Database& database, const std::string& case_id, std::size_t number, const Record& record) {
  static const std::string sql = insertion();
  Statement row = database.query(sql, case_id, static_cast<std::int64_t>(number));
  int parameter = 2;
  for (std::size_t i = 0; i < kObservableCount; ++i)
    if (kObservables[i].is_in_database) row.bind(++parameter, record.values[i]);
  while (row.step()) {
  }
}

Record stored_record(const Statement& row) {
  Record record;
  int column = 0;
  for (std::size_t i = 0; i < kObservableCount; ++i)
    if (kObservables[i].is_in_database) record.values[i] = row.real(column++);
  return record;
}

/// The number of the file in its file system, also through a symbolic link; 0 if there is no such file.
ino_t inode_of(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? status.st_ino : 0;
}

}  // namespace

HistoryTail::News HistoryTail::read_new() {
  const ino_t inode = inode_of(file_);
  const bool is_another = inode != inode_;
  if (is_another) {
    inode_ = inode;
    offset_ = 0;
    size_ = 0;
  }
  News news{size_, {}, is_another && inode != 0};
  std::ifstream stream(file_, std::ios::binary);
  stream.seekg(offset_);
  std::string line;
  while (std::getline(stream, line) && !stream.eof()) {  // eof: the line has no line end yet
    const auto record = parse_record(line);
    if (!record) break;
    news.records.push_back(*record);
    offset_ += static_cast<std::streamoff>(line.size()) + 1;
  }
  size_ += news.records.size();
  return news;
}

/// Text after the last line end is ignored: the process ended while it was writing that line.
HistoryFile read_history(const std::filesystem::path& file) try {
  const std::optional<std::string> text = read_file(file);
  if (!text) return {{}, "is missing"};
  HistoryFile history;
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const auto record = parse_record(line);
    if (!record) {
      history.damage = "is damaged in line " + std::to_string(history.records.size() + 1);
      break;
    }
    history.records.push_back(*record);
  }
  return history;
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return {{}, "cannot be read: " + error.code().message()};
}

std::string history_lines(const History& records) {
  std::string lines;
  for (const Record& record : records) lines += to_json_line(record, Missing::left_out) + '\n';
  return lines;
}

void store_history(Database& database, const std::string& case_id, std::size_t first,
                   const History& records) {
  if (records.empty()) return;
  Transaction transaction(database, Survives::kill);  // not synced: the run directory holds the records, too
  for (const Record& record : records) store_record(database, case_id, first++, record);
  database.execute("UPDATE cases SET kt = ? WHERE id = ?", records.back()["kt"], case_id);
  transaction.commit();
}

void store_history_file(Database& database, const std::string& case_id, const HistoryFile& file) {
  store_history(database, case_id, 0, file.records);
  if (file.damage.empty())
    database.execute("DELETE FROM histories WHERE case_id = ? AND record >= ?", case_id,
                     static_cast<std::int64_t>(file.records.size()));
}

History stored_history(Database& database, const std::string& case_id) {
  History records;
  Statement row = database.query(
      "SELECT " + history_columns_in(database) + " FROM histories WHERE case_id = ? ORDER BY record",
      case_id);
  while (row.step()) records.push_back(stored_record(row));
  return records;
}

}  // namespace capstan
