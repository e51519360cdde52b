#pragma once
// A Slurm of the test's own on this machine (private_slurm.sh). While an object of this class exists, the
// commands of Slurm reach that one.
#include <string>

#include "tests/support/temporary_directory.hpp"

namespace capstan {

class PrivateSlurm {
 public:
  /// Whether Slurm's programs are installed.
  static bool is_installed();

  /// Starts it; the nodes n1, n2, .. have two cores each. Throws std::runtime_error if that fails.
  explicit PrivateSlurm(int nodes);
  ~PrivateSlurm();
  PrivateSlurm(const PrivateSlurm&) = delete;
  PrivateSlurm& operator=(const PrivateSlurm&) = delete;

  void kill_controller() { run("kill-controller"); }
  void start_controller() { run("start-controller"); }
  /// The processes of the node end, and Slurm is told that it is down, as its administrator would tell it.
  void lose_node(const std::string& node);

 private:
  void run(const std::string& command, const std::string& argument = "") const;

  TemporaryDirectory directory_;
};

}  // namespace capstan
