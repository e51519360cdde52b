#pragma once
// Fake commands of Slurm, first in PATH while an object of this class exists. What they were called with is
// kept; what they answer is set by the test.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {

class FakeSlurm {
 public:
  FakeSlurm() : path_(std::getenv("PATH")) {
    for (const char* command : {"sbatch", "squeue", "scancel"}) {
      // %q keeps the words apart; the lists that are there when sbatch is called are kept, too.
      overwrite(file(command), "#!/bin/bash\nd=" + directory_.path().string() + "; c=" + command +
                                   "\nprintf '%q ' \"$@\" >>$d/$c.calls; echo >>$d/$c.calls\n"
                                   "[ $c = sbatch ] && cat \"${!#%/*}\"/*.list >>$d/submitted\n"
                                   "cat $d/$c.output 2>/dev/null; cat $d/$c.errors >&2 2>/dev/null\n"
                                   "[ ! -e $d/$c.errors ]\n");
      std::filesystem::permissions(file(command), std::filesystem::perms::owner_all);
    }
    setenv("PATH", (directory_.path().string() + ":" + path_).c_str(), 1);
  }
  ~FakeSlurm() { setenv("PATH", path_.c_str(), 1); }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  /// What the command prints, from now on.
  void answer(const std::string& command, const std::string& output) {
    std::filesystem::remove(file(command + ".errors"));
    overwrite(file(command + ".output"), output);
  }
  /// From now on the command prints an error and fails.
  void fail(const std::string& command, const std::string& error) {
    overwrite(file(command + ".errors"), error + "\n");
  }

  /// The arguments of all calls, one line each.
  std::vector<std::string> calls(const std::string& command) const {
    std::vector<std::string> all;
    std::ifstream stream(file(command + ".calls"));
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
  }
  /// The lists that were there when sbatch was called.
  std::string submitted_lists() const { return file_bytes(file("submitted")); }

 private:
  std::filesystem::path file(const std::string& name) const { return directory_.path() / name; }

  TemporaryDirectory directory_;
  const std::string path_;
};

}  // namespace capstan
