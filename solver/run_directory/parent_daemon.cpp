#include "solver/run_directory/parent_daemon.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "solver/run_directory/exit_code.hpp"

namespace capstan {

void end_with_daemon() {
  const char* daemon = std::getenv(kDaemonVariable);
  if (!daemon) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const bool ended_before = std::to_string(getppid()) != daemon;
  if (ended_before) std::_Exit(kExitInterrupted);
}

}  // namespace capstan
