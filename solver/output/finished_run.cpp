#include "solver/output/finished_run.hpp"

#include <sstream>

#include "solver/case/content_id.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

History read_records(const RunDirectory& directory) {
  History records;
  std::istringstream lines(read_file(directory.history_file()).value_or(""));
  for (std::string line; std::getline(lines, line);)
    if (const auto record = parse_record(line)) records.push_back(*record);
  return records;
}

bool belongs_to(const nlohmann::ordered_json& result, const Case& c) {
  return result.value("case", nlohmann::ordered_json()) == to_json(c) &&
         result.value(nlohmann::ordered_json::json_pointer("/trust/numerics_version"), 0) == kNumericsVersion;
}

}  // namespace

Stop FinishedRun::stop() const { return parse_word<Stop>(result["stop"].get<std::string>()).value(); }

std::optional<FinishedRun> finished_run(const RunDirectory& directory, const Case& c) {
  auto result = directory.result();
  if (!result || !belongs_to(*result, c)) return std::nullopt;
  return FinishedRun{c, read_records(directory), std::move(*result)};
}

}  // namespace capstan
