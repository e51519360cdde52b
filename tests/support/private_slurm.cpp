#include "tests/support/private_slurm.hpp"

#include <cstdlib>
#include <stdexcept>

#include "tests/support/source_directory.hpp"

namespace capstan {

bool PrivateSlurm::is_installed() {
  return std::system("PATH=$PATH:/usr/sbin; command -v slurmctld slurmd munged sbatch >/dev/null") == 0;
}

PrivateSlurm::PrivateSlurm(int nodes) {
  run("start", std::to_string(nodes));
  setenv("SLURM_CONF", (directory_.path() / "slurm.conf").c_str(), 1);
}

PrivateSlurm::~PrivateSlurm() {
  std::system(("sh " + (source_directory() / "tests/support/private_slurm.sh").string() + " stop " +
               directory_.path().string())
                  .c_str());
  unsetenv("SLURM_CONF");
}

void PrivateSlurm::lose_node(const std::string& node) {
  run("kill-node", node);
  if (std::system(("scontrol update NodeName=" + node + " State=DOWN Reason=lost").c_str()) != 0)
    throw std::runtime_error("scontrol failed");
}

void PrivateSlurm::run(const std::string& command, const std::string& argument) const {
  const std::string words = "sh " + (source_directory() / "tests/support/private_slurm.sh").string() + " " +
                            command + " " + directory_.path().string() + " " + argument;
  if (std::system(words.c_str()) != 0) throw std::runtime_error("failed: " + words);
}

}  // namespace capstan
