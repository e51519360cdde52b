#pragma once
// The environment of the programs that the daemon starts.
#include <string>
#include <vector>

namespace capstan {

/// The environment of this process without Capstan's own variables: above all without the bearer token, as
/// the environment of a process can be read in /proc, and a cluster stores that of a job.
std::vector<std::string> child_environment();

/// The words as posix_spawn takes them; valid as long as they are.
std::vector<char*> pointers_to(std::vector<std::string>& words);

}  // namespace capstan
