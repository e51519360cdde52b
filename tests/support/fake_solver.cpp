// The program `capstan` with a solver without physics. It keeps to schema/run_directory.md; the viscosity
// ratio V of the case selects what it does.
//
//   V = 40  uses its core until there is a file `go` in its directory, then completes
//   V = 45  allocates memory without end
//   V = 46  writes a record of its history every 10 ms, without end
//   V = 50  diverges: exit code 3, result.json says why
//   V = 60  dies by abort()
//   V = 70  writes half of its history, waits for SIGTERM, exits with 75; the same when it is resumed
//   V = 80  the same, but completes when it is resumed
//   V = 90  refuses the case: exit code 2
//   V = 55  as V = 50, but only at fidelity `fast`; else it completes
//   V = 95  as V = 90, but only at fidelity `fast`; else it completes
//   other   completes: tumbling below Ca = 0.5, tank-treading above
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "runner/cli/program.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/history_line.hpp"
#include "solver/run_directory/run_directory.hpp"
#include "solver/run_directory/stop_signals.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr int kRecords = 10;

void write_history(const RunDirectory& directory, double until, int records) {
  std::ofstream history(directory.history_file(), std::ios::trunc);
  Record record;
  for (int i = 1; i <= records; ++i) {
    record["kt"] = until * i / kRecords;
    record["D_xy"] = 0.5;
    record["theta"] = -0.1 * i;
    record["psi"] = 0.01 * i;
    record["volume"] = 4.18;
    record["area"] = 17.2;
    record["iterations"] = 2;
    record["error"] = 1e-4;
    history << to_json_line(record) << std::endl;
  }
}

void write_result(const RunDirectory& directory, const ordered_json& result) {
  write_atomically(directory.result_file(), result.dump());
}

int wait_for_interruption(const RunDirectory& directory, double until) {
  const sigset_t signals = stop_signals();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  write_history(directory, until, kRecords / 2);
  std::ofstream(directory.checkpoint_paths()[0]) << "half of it";
  int signal = 0;
  sigwait(&signals, &signal);
  return kExitInterrupted;
}

void compute_until(const std::filesystem::path& file) {
  while (!std::filesystem::exists(file)) {
  }
}

[[noreturn]] void write_without_end(const RunDirectory& directory) {
  for (std::ofstream history(directory.history_file(), std::ios::trunc);; usleep(10000))
    history << R"({"kt":0.1,"D_xy":0.5,"theta":-0.1,"psi":0.01,"volume":4.18,"area":17.2})" << std::endl;
}

[[noreturn]] void take_memory_without_end() {
  for (std::vector<std::string> taken;;) taken.emplace_back(1 << 20, 'x'), usleep(1000);
}

int complete(const RunDirectory& directory, double until, double Ca) {
  write_history(directory, until, kRecords);
  write_result(directory, {{"format", 1},
                           {"stop", "reached_end"},
                           {"message", ""},
                           {"motion", Ca < 0.5 ? "tumbling" : "tank_treading"},
                           {"evidence", {{"turns", 2.0}, {"margin", 0.25}}},
                           {"confirmed", true},
                           {"error", {{"Q", 0.01}, {"D_xy", 0.01}, {"label_agrees", true}}},
                           {"final", {{"kt", until}, {"D_xy", 0.5}, {"theta", -1.0}}}});
  return kExitDone;
}

bool is_coarse(const ordered_json& input) { return input["fidelity"]["nodes"] <= 642; }

int solve(const std::filesystem::path& case_file, const std::filesystem::path& out, double,
          const std::filesystem::path&) {
  const RunDirectory directory(out);
  const ordered_json input = ordered_json::parse(std::ifstream(case_file));
  const double V = input["V"];
  const double until = input["until"]["kt"];
  if (V == 70 || (V == 80 && !std::filesystem::exists(directory.checkpoint_paths()[0])))
    return wait_for_interruption(directory, until);
  unblock_stop_signals();
  if (V == 40) compute_until(out / "go");
  if (V == 46) write_without_end(directory);
  if (V == 45) take_memory_without_end();
  if (V == 50 || (V == 55 && is_coarse(input))) {
    write_result(directory,
                 {{"stop", "diverged"}, {"message", "the membrane tore at kt = 0.3"}, {"motion", nullptr}});
    return kExitNoAnswer;
  }
  if (V == 60) {
    std::cerr << "something is very wrong" << std::endl;
    std::abort();
  }
  if (V == 90 || (V == 95 && is_coarse(input))) {
    std::cerr << "/V  cannot be " << V << std::endl;
    return kExitInvalidInput;
  }
  return complete(directory, until, input["Ca"]);
}

}  // namespace
}  // namespace capstan

int main(int argc, char** argv) { return capstan::run_program(argc, argv, {.solve = capstan::solve}); }
