#pragma once
// The program `capstan`: a table of subcommands.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace capstan {

class BenchReport;
struct Study;

/// A measurement of `capstan bench`.
struct Benchmark {
  std::string name, summary;
  std::string duration;  ///< "about a minute"
  std::function<void(BenchReport& report)> run;
};

/// The commands that need the physics, which the rest of the program does not know. Each returns its exit
/// code.
struct Physics {
  /// `capstan solve`: one case in its directory, for so many seconds
  std::function<int(const std::filesystem::path& case_file, const std::filesystem::path& out,
                    double wall_seconds)>
      solve;
  /// `capstan compare`: the fluid models on the same cases
  std::function<int(const std::vector<std::filesystem::path>& case_files, bool json)> compare = nullptr;
  /// `capstan estimate`: what a study costs on this machine; the study file is valid
  std::function<int(const Study& study, int cores, bool json)> estimate = nullptr;
  /// `capstan bench`
  std::vector<Benchmark> benchmarks = {};
  /// of the sources, as git names it, or "" if nobody knows
  std::string revision = {};
};

int run_program(int argc, char** argv, const Physics& physics);

}  // namespace capstan
