#include "runner/store/disk_usage.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <set>

#include "runner/store/database.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

std::uint64_t bytes_of(const fs::path& file) {
  constexpr std::uint64_t kBlock = 512;  // stat(2)
  struct stat status {};
  return lstat(file.c_str(), &status) == 0 ? kBlock * static_cast<std::uint64_t>(status.st_blocks) : 0;
}

RunUsage usage_of(const fs::path& run) {
  RunUsage usage;
  std::error_code gone;  // a run that goes on replaces its files
  for (auto entry = fs::recursive_directory_iterator(run, gone); entry != fs::recursive_directory_iterator();
       entry.increment(gone)) {
    const std::string name = entry->path().filename();
    const bool is_shape = name.starts_with("shapes") || entry->path().parent_path().filename() == "shapes";
    (is_shape                         ? usage.shapes
     : name.starts_with("checkpoint") ? usage.checkpoints
                                      : usage.other) += bytes_of(entry->path());
    if (gone) break;
  }
  return usage;
}

std::map<std::string, RunUsage> usage_of_runs(const fs::path& runs) {
  std::map<std::string, RunUsage> usage;
  for (const auto& entry : fs::directory_iterator(runs))
    usage[entry.path().filename()] = usage_of(entry.path());
  return usage;
}

}  // namespace

RunUsage& RunUsage::operator+=(const RunUsage& more) {
  shapes += more.shapes;
  checkpoints += more.checkpoints;
  other += more.other;
  return *this;
}

DiskUsage disk_usage(const fs::path& data) {
  if (!fs::exists(data / "capstan.sqlite"))
    throw std::runtime_error(data.string() + " is no data directory: it holds no capstan.sqlite");
  Database database(data / "capstan.sqlite", Database::Access::read);
  const auto of_run = usage_of_runs(data / "runs");
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
  for (const char* end : {"", "-wal", "-shm"})
    usage.database += bytes_of(data / ("capstan.sqlite" + std::string(end)));
  std::stable_sort(usage.studies.begin(), usage.studies.end(),
                   [](const StudyUsage& a, const StudyUsage& b) { return a.runs.total() > b.runs.total(); });
  return usage;
}

}  // namespace capstan
