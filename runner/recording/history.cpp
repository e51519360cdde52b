#include "runner/recording/history.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

std::optional<HistoryRecord> parse_record(const std::string& line) {
  const nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  HistoryRecord record;
  for (std::size_t column = 0; column < record.size(); ++column) {
    const auto found = object.find(kHistoryColumns[column]);
    const bool is_number = found != object.end() && found->is_number();
    record[column] = is_number ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
  }
  return record;
}

}  // namespace

std::vector<HistoryRecord> HistoryTail::read_new() {
  std::vector<HistoryRecord> records;
  std::ifstream stream(file_, std::ios::binary);
  stream.seekg(offset_);
  std::string line;
  while (std::getline(stream, line) && !stream.eof()) {  // at the end of the file the line lacks its newline
    const auto record = parse_record(line);
    if (!record) break;
    records.push_back(*record);
    offset_ += static_cast<std::streamoff>(line.size()) + 1;
  }
  size_ += records.size();
  return records;
}

/// What follows the last newline was still being written when the process ended.
HistoryFile read_history(const std::filesystem::path& file) try {
  const std::optional<std::string> text = read_file(file);
  if (!text) return {{}, "is missing"};
  HistoryFile history;
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const auto record = parse_record(line);
    if (!record) {
      history.fault = "is damaged in line " + std::to_string(history.records.size() + 1);
      break;
    }
    history.records.push_back(*record);
  }
  return history;
} catch (const std::filesystem::filesystem_error& error) {
  if (is_shortage(error)) throw;
  return {{}, "cannot be read: " + error.code().message()};
}

std::string history_lines(const std::vector<HistoryRecord>& records) {
  std::string lines;
  for (const HistoryRecord& record : records) {
    nlohmann::ordered_json line;
    for (std::size_t column = 0; column < record.size(); ++column)
      if (!std::isnan(record[column])) line[kHistoryColumns[column]] = record[column];
    lines += line.dump() + '\n';
  }
  return lines;
}

void store_history(Database& database, const std::string& case_id, std::size_t first,
                   const std::vector<HistoryRecord>& records) {
  if (records.empty()) return;
  Transaction transaction(database, Survives::kill);  // the run directory has them, too
  for (const HistoryRecord& record : records) {
    const auto& [kt, D_xy, theta, psi, volume, area] = record;
    database.execute("INSERT OR REPLACE INTO histories VALUES (?, ?, ?, ?, ?, ?, ?, ?)", case_id,
                     static_cast<std::int64_t>(first++), kt, D_xy, theta, psi, volume, area);
  }
  database.execute("UPDATE cases SET kt = ? WHERE id = ?", records.back()[0], case_id);
  transaction.commit();
}

void store_history_file(Database& database, const std::string& case_id, const HistoryFile& file) {
  store_history(database, case_id, 0, file.records);
  if (file.fault.empty())
    database.execute("DELETE FROM histories WHERE case_id = ? AND record >= ?", case_id,
                     static_cast<std::int64_t>(file.records.size()));
}

std::vector<HistoryRecord> stored_history(Database& database, const std::string& case_id) {
  std::vector<HistoryRecord> records;
  Statement row = database.query(
      "SELECT kt, D_xy, theta, psi, volume, area FROM histories WHERE case_id = ? ORDER BY record", case_id);
  while (row.step()) {
    HistoryRecord& record = records.emplace_back();
    for (std::size_t column = 0; column < record.size(); ++column)
      record[column] = row.real(static_cast<int>(column));
  }
  return records;
}

}  // namespace capstan
