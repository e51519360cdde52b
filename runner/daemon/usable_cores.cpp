#include "runner/daemon/usable_cores.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace capstan {
namespace {

constexpr const char* kControlGroups = "/sys/fs/cgroup";

int cores_by_affinity() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());  // more cores than a cpu_set_t holds
}

/// The path of this process's control group (cgroup v2); "/" if it has none.
std::string own_control_group() {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("0::")) return line.substr(3);
  return "/";
}

/// The quota in a file `cpu.max`, in cores; 0 if there is none. The file holds "QUOTA PERIOD" in
/// microseconds, or "max PERIOD".
int cores_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  double quota = 0, period = 0;
  if (!(stream >> quota >> period) || quota <= 0 || period <= 0) return 0;
  return static_cast<int>(std::ceil(quota / period));
}

}  // namespace

int cores_by_quota(const std::filesystem::path& root, const std::string& group) {
  int min = 0;
  for (std::filesystem::path path = std::filesystem::path(group).relative_path();;
       path = path.parent_path()) {
    const int cores = cores_in(root / path / "cpu.max");
    if (cores > 0 && (min == 0 || cores < min)) min = cores;
    if (path.empty()) return min;
  }
}

int cores_by_slurm() {
  const char* cores = std::getenv("SLURM_CPUS_ON_NODE");
  return cores ? std::max(0, std::atoi(cores)) : 0;
}

int usable_cores() {
  int cores = std::max(1, cores_by_affinity());
  for (const int limit : {cores_by_quota(kControlGroups, own_control_group()), cores_by_slurm()})
    if (limit > 0) cores = std::min(cores, limit);
  return cores;
}

}  // namespace capstan
