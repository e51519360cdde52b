#include "runner/slurm/job_directory.hpp"

#include <algorithm>

namespace capstan {

std::vector<int> JobDirectory::tasks() const {
  std::vector<int> tasks;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    if (entry.path().extension() == ".list") tasks.push_back(std::stoi(entry.path().stem()));
  std::sort(tasks.begin(), tasks.end());
  return tasks;
}

}  // namespace capstan
