#include "runner/store/disk_usage.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <set>

#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"
#include "runner/store/database_files.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

/// Several runs share a file where one goes on from another: each counts its part.
std::uint64_t allocated_bytes(const fs::path& file) {
  constexpr std::uint64_t kBlock = 512;  // stat(2)
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0) return 0;
  return kBlock * static_cast<std::uint64_t>(status.st_blocks) / std::max<std::uint64_t>(status.st_nlink, 1);
}

RunBytes usage_of(const RunDirectory& run) {
  RunBytes usage;
  std::error_code gone;  // files may vanish: a run in progress replaces its files
  for (auto entry = fs::recursive_directory_iterator(run.path(), gone);
       entry != fs::recursive_directory_iterator(); entry.increment(gone)) {
    const fs::path& file = entry->path();
    (run.is_shape(file)        ? usage.shapes
     : run.is_checkpoint(file) ? usage.checkpoints
                               : usage.other) += allocated_bytes(file);
    if (gone) break;
  }
  return usage;
}

std::map<std::string, RunBytes> usage_of_runs(const fs::path& runs) {
  std::map<std::string, RunBytes> usage;
  for (const auto& entry : fs::directory_iterator(runs))
    usage[entry.path().filename()] = usage_of(RunDirectory(entry.path()));
  return usage;
}

}  // namespace

RunBytes& RunBytes::operator+=(const RunBytes& more) {
  shapes += more.shapes;
  checkpoints += more.checkpoints;
  other += more.other;
  return *this;
}

DiskUsage disk_usage(const fs::path& data) {
  expect_data_directory(data);
  Database database(data / kDatabaseName, Database::Access::read);
  const auto of_run = usage_of_runs(data / kRunsName);
  DiskUsage usage;
  std::set<std::string> wanted;
  Statement row = database.query("SELECT DISTINCT study_id, case_id FROM study_cases ORDER BY study_id");
  while (row.step()) {
    if (usage.studies.empty() || usage.studies.back().study != row.text(0))
      usage.studies.push_back({row.text(0), 0, {}});
    const auto found = of_run.find(row.text(1));
    ++usage.studies.back().cases;
    if (found != of_run.end()) usage.studies.back().runs += found->second;
    wanted.insert(row.text(1));
  }
  for (const auto& [id, run] : of_run) {
    usage.runs += run;
    if (!wanted.contains(id)) usage.without_study += run;
  }
  for (const fs::path& file : files_of_database(data / kDatabaseName))
    usage.database += allocated_bytes(file);
  std::stable_sort(usage.studies.begin(), usage.studies.end(),
                   [](const StudyUsage& a, const StudyUsage& b) { return a.runs.total() > b.runs.total(); });
  return usage;
}

}  // namespace capstan
