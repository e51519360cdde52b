#pragma once
// How many cores this process may use.
#include <filesystem>
#include <string>

namespace capstan {

/// The cores of its affinity mask, which the kernel keeps within its cpuset (taskset, docker --cpuset-cpus, a
/// batch system), but no more than its control groups give it time for (docker --cpus). At least 1.
int usable_cores();

/// The cores for which a control group and those above it (cgroup v2) give time, rounded up; 0 where there is
/// no limit. \param group  its path below `root`, as in /proc/self/cgroup
int cores_by_quota(const std::filesystem::path& root, const std::string& group);

}  // namespace capstan
