// The commands for a cluster on which no daemon may run.
#include <sys/stat.h>

#include <filesystem>
#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/slurm/collect.hpp"
#include "runner/slurm/export_cases.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {

int export_study(const ExportArguments& arguments) {
  const auto study = read_study_file(arguments.file);
  if (!study) return kExitInvalidInput;
  const std::size_t tasks =
      export_cases(*study, arguments.directory, static_cast<std::size_t>(arguments.jobs),
                   std::filesystem::canonical("/proc/self/exe"));
  std::cout << study->cases.size() << " cases in " << tasks << " tasks: cd " << arguments.directory
            << " && sbatch job.sh\n";
  return kExitDone;
}

int collect_results(const CollectArguments& arguments) {
  umask(077);  // files of a data directory are readable by this user alone
  const std::filesystem::path directory(arguments.directory);
  const auto study = read_study_file(directory / kExportedStudy);
  if (!study) return kExitInvalidInput;
  const SystemClock clock;
  const DataDirectory data(arguments.data);
  QueueWriter writer(data.database(), clock, JobQueue::kLease);
  const Collection collection = collect(*study, directory, data, writer, clock);
  if (arguments.json)
    std::cout << nlohmann::ordered_json{{"study", collection.study_id},
                                        {"recorded", collection.recorded},
                                        {"known", collection.known},
                                        {"unfinished", collection.unfinished}}
                     .dump(2)
              << '\n';
  else
    std::cout << collection.study_id << ": " << collection.recorded << " results recorded, "
              << collection.known << " known before, " << collection.unfinished
              << " cases without a result\n";
  return kExitDone;
}

}  // namespace capstan
