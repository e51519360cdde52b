#include "runner/results/history.hpp"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

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

void cut_history(Database& database, const std::string& case_id, std::size_t first) {
  database.execute("DELETE FROM histories WHERE case_id = ? AND record >= ?", case_id,
                   static_cast<std::int64_t>(first));
}

}  // namespace capstan
