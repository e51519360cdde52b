#pragma once
// The number of cores that this process may use.
#include <filesystem>
#include <string>

namespace capstan {

/// The smaller of two numbers: the cores of the process's affinity mask (set by taskset, docker
/// --cpuset-cpus, a batch system) and the processor time that its control groups allow (docker --cpus). At
/// least 1.
int usable_cores();

/// The smallest quota of a control group (cgroup v2) and its ancestors, in cores, rounded up; 0 if there is
/// none.
/// \param root   where the control groups are mounted
/// \param group  the path of the group below `root`, as in /proc/self/cgroup
int cores_by_quota(const std::filesystem::path& root, const std::string& group);

}  // namespace capstan
