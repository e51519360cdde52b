#pragma once
// The program `capstan`: its commands, its exit codes.
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace capstan {

struct Study;

/// A subcommand of `capstan bench`.
struct Benchmark {
  std::string name, summary;
  std::string duration;  ///< in words: "about a minute"
  /// Prints tables, or one JSON document if `json` is set.
  std::function<void(std::ostream& out, bool json)> run;
};

/// The commands that need the whole solver. They are handed in by main(), because the library of the other
/// commands is not linked with it. Each function returns the exit code.
struct WorkerCommands {
  /// `capstan solve`.
  /// \param out           run directory
  /// \param wall_seconds  time limit: then the run writes a checkpoint and stops
  /// \param shorter       directory of a run from whose end this one goes on; empty: it starts at kt = 0
  std::function<int(const std::filesystem::path& case_file, const std::filesystem::path& out,
                    double wall_seconds, const std::filesystem::path& shorter)>
      solve;
  /// `capstan compare`
  std::function<int(const std::vector<std::filesystem::path>& case_files, bool json)> compare = nullptr;
  /// `capstan estimate`.
  /// \param study  a valid study
  /// \param cores  number of cases that would run at the same time
  std::function<int(const Study& study, int cores, bool json)> estimate = nullptr;
  /// `capstan tradeoff`.
  /// \param scenes  their names; none: all
  std::function<int(const std::vector<std::string>& scenes, bool json)> tradeoff = nullptr;
  /// `capstan bench`
  std::vector<Benchmark> benchmarks = {};
  /// git revision of the sources; empty if unknown
  std::string revision = {};
};

/// Parses the command line, runs the command and returns its exit code (schema/exit_codes.md). Errors go to
/// standard error; no exception leaves it.
int run_program(int argc, char** argv, const WorkerCommands& worker);

}  // namespace capstan
