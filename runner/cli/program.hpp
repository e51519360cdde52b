#pragma once
// The program `capstan`: a table of subcommands.
#include <filesystem>
#include <functional>
#include <vector>

namespace capstan {

/// The commands that need the physics, which the rest of the program does not know. Each returns its exit code.
struct Physics {
  /// `capstan solve`: one case in its directory
  std::function<int(const std::filesystem::path& case_file, const std::filesystem::path& out)> solve;
  /// `capstan compare`: the fluid models on the same cases
  std::function<int(const std::vector<std::filesystem::path>& case_files)> compare;
};

int run_program(int argc, char** argv, const Physics& physics);

}  // namespace capstan
