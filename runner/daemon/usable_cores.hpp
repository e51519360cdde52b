#pragma once
// The number of cores that this process may use.
#include <filesystem>
#include <string>

namespace capstan {

/// The smallest of three numbers: the cores of the process's affinity mask (set by taskset, docker
/// --cpuset-cpus, a batch system), the processor time that its control groups allow (docker --cpus), and
/// within a job of Slurm the cores that the job has on this node. At least 1.
int usable_cores();

/// The cores of this process's job on this node (SLURM_CPUS_ON_NODE); 0 outside of a job. Slurm sets no
/// affinity mask where its plugin for that is switched off.
int cores_by_slurm();

/// The smallest quota of a control group (cgroup v2) and its ancestors, in cores, rounded up; 0 if there is
/// none.
/// \param root   where the control groups are mounted
/// \param group  the path of the group below `root`, as in /proc/self/cgroup
int cores_by_quota(const std::filesystem::path& root, const std::string& group);

}  // namespace capstan
