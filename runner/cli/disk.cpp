#include <cmath>
#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/render/table.hpp"
#include "runner/store/disk_usage.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

ordered_json megabytes(std::uint64_t bytes) { return std::round(static_cast<double>(bytes) / 1e4) / 100; }

ordered_json document_of(const RunBytes& runs) {
  return {{"bytes", runs.total()},
          {"shapes", runs.shapes},
          {"checkpoints", runs.checkpoints},
          {"other", runs.other}};
}

ordered_json document_of(const DiskUsage& usage) {
  ordered_json studies = ordered_json::array();
  for (const StudyUsage& study : usage.studies) {
    ordered_json row = {{"study", study.study}, {"cases", study.cases}};
    row.update(document_of(study.runs));
    studies.push_back(row);
  }
  return {{"studies", studies},
          {"without_study", document_of(usage.without_study)},
          {"runs", document_of(usage.runs)},
          {"database_bytes", usage.database}};
}

std::string text_of(const DiskUsage& usage) {
  Table table{{"study", "cases", "MB", "shapes", "checkpoints", "other"}, {}};
  const auto add = [&](const std::string& name, const ordered_json& cases, const RunBytes& runs) {
    table.rows.push_back({name, cases, megabytes(runs.total()), megabytes(runs.shapes),
                          megabytes(runs.checkpoints), megabytes(runs.other)});
  };
  for (const StudyUsage& study : usage.studies) add(study.study, study.cases, study.runs);
  if (usage.without_study.total() > 0) add("(of no study)", nullptr, usage.without_study);
  add("(all runs)", nullptr, usage.runs);
  table.rows.push_back({"(database)", nullptr, megabytes(usage.database), nullptr, nullptr, nullptr});
  return as_text(table);
}

}  // namespace

int print_disk_usage(const UpkeepArguments& arguments) {
  const DiskUsage usage = disk_usage(arguments.data);
  std::cout << (arguments.json ? document_of(usage).dump(2) + "\n" : text_of(usage));
  return kExitDone;
}

}  // namespace capstan
