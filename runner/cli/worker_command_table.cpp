// Rows of the commands that compute in this process, without a server.
#include <iostream>
#include <limits>

#include "runner/cli/command_table.hpp"
#include "runner/cli/options.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/daemon/usable_cores.hpp"
#include "runner/slurm/solve_list.hpp"
#include "runner/study/input_file.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/parent_daemon.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {
namespace {

struct SolveArguments {
  std::filesystem::path file, out, shorter;
  double wall_seconds = std::numeric_limits<double>::infinity();
  bool json = false;
};

Command solve_command(const WorkerCommands& worker) {
  return command<SolveArguments>(
      "solve", "compute one case, or resume it, without a server",
      {[](CLI::App& parser, SolveArguments& arguments) {
        parser
            .add_option("CASE", arguments.file,
                        "the case (its schema: GET /case.schema.json); - is standard input")
            ->required();
        parser.add_option("--out", arguments.out, "the run directory; made if it is not there")->required();
        parser
            .add_option("--wall-time", arguments.wall_seconds,
                        "seconds after which it stops with a checkpoint (exit code 75); without it, it runs "
                        "to its end")
            ->check(CLI::PositiveNumber)
            ->type_name("S");
        parser
            .add_option("--from", arguments.shorter,
                        "directory of a run of the same case to an earlier end: this run goes on from there")
            ->type_name("DIR");
        parser.add_flag("--json", arguments.json, "print the run's result.json at the end");
      }},
      "A run that was killed goes on where it stood when the same command is given again.\n"
      "Example:\n"
      "  capstan solve case.json --out runs/first\n"
      "  capstan solve longer.json --from runs/first --out runs/longer\n",
      [solve = worker.solve](const SolveArguments& arguments) {
        end_with_daemon();
        publish_only_as_own_attempt(RunDirectory(arguments.out));
        const int code = solve(arguments.file, arguments.out, arguments.wall_seconds, arguments.shorter);
        if (arguments.json && (code == kExitDone || code == kExitNoAnswer))
          std::cout << read_input(RunDirectory(arguments.out).result_file());
        return code;
      });
}

struct SolveListArguments {
  std::filesystem::path list, journal;
};

Command solve_list_command() {
  return command<SolveListArguments>(
      "solve-list", "compute the cases of a list one after another, as a job of a cluster does",
      {[](CLI::App& parser, SolveListArguments& arguments) {
        parser
            .add_option("LIST", arguments.list, "the list: a token, an id and a run directory on each line")
            ->required();
        parser.add_option("--journal", arguments.journal, "where beginnings and ends are noted")->required();
      }},
      "SIGUSR1 and SIGTERM: the present case writes a checkpoint, and the job ends with exit code 75.\n"
      "Example:\n  capstan solve-list 0.list --journal 0.journal\n",
      [](const SolveListArguments& arguments) {
        end_with_daemon();
        return solve_list(arguments.list, arguments.journal);
      });
}

struct CompareArguments {
  std::vector<std::filesystem::path> files;
  bool json = false;
};

Command compare_command(const WorkerCommands& worker) {
  return command<CompareArguments>(
      "compare", "run the same case with all fluid models and tell how far they agree",
      {[](CLI::App& parser, CompareArguments& arguments) {
         parser
             .add_option("CASE", arguments.files,
                         "the cases (their schema: GET /case.schema.json), - is standard input; their fluid "
                         "and grid are "
                         "set here")
             ->required();
       },
       options::json},
      "Prints D_xy and theta at the end of each run, and what is left between the models without spacing and "
      "walls.\n"
      "Example:\n  capstan compare studies/cross_validation/*.json\n",
      [compare = worker.compare](const CompareArguments& arguments) {
        return compare(arguments.files, arguments.json);
      });
}

struct EstimateArguments {
  std::string file;
  int cores = usable_cores();
  bool json = false;
};

Command estimate_command(const WorkerCommands& worker) {
  return command<EstimateArguments>(
      "estimate", "how long a study takes on this machine, before it is submitted",
      {options::file("the study; - is standard input"), options::cores("cases that will run side by side"),
       options::json},
      "Runs some of the cases for a moment, two seconds in all; nothing is submitted.\n"
      "Example:\n  capstan estimate studies/fig17/study.json\n",
      [estimate = worker.estimate](const EstimateArguments& arguments) {
        const auto study = read_study_file(arguments.file);
        return study ? estimate(*study, arguments.cores, arguments.json) : kExitInvalidInput;
      });
}

struct TradeoffArguments {
  std::vector<std::string> scenes;
  bool json = false;
};

Command tradeoff_command(const WorkerCommands& worker) {
  return command<TradeoffArguments>(
      "tradeoff", "measure time and error of many numerical settings on fixed scenes",
      {[](CLI::App& parser, TradeoffArguments& arguments) {
         parser.add_option("SCENE", arguments.scenes, "only these scenes (column scene); default: all");
       },
       options::json},
      "Runs each scene with boundary integrals and on the lattice: at all rungs of resolution, and with each "
      "setting alone changed from rung 2. Prints CSV, a row a run, with its distance to the finest rung of "
      "the same flow model. All scenes take about a quarter of an hour on one core.\n"
      "Example:\n  capstan tradeoff red_cell_0.25_4 > tradeoff.csv\n",
      [tradeoff = worker.tradeoff](const TradeoffArguments& arguments) {
        return tradeoff(arguments.scenes, arguments.json);
      });
}

struct BenchmarkArguments {
  bool json = false;
};

Command benchmark_command(const Benchmark& benchmark) {
  return command<BenchmarkArguments>(
      benchmark.name, benchmark.summary, {options::json},
      "Takes " + benchmark.duration +
          " on a quiet machine. Threads: OMP_NUM_THREADS, or all cores.\nExample:\n  capstan bench " +
          benchmark.name + "\n",
      [benchmark](const BenchmarkArguments& arguments) {
        std::cerr << "capstan bench " << benchmark.name << " takes " << benchmark.duration << std::endl;
        benchmark.run(std::cout, arguments.json);
        return kExitDone;
      });
}

Command bench_command(const WorkerCommands& worker) {
  Command bench{"bench", "measure how fast the solver is on this machine"};
  for (const Benchmark& benchmark : worker.benchmarks)
    bench.subcommands.push_back(benchmark_command(benchmark));
  return bench;
}

}  // namespace

std::vector<Command> worker_commands(const WorkerCommands& worker) {
  return {solve_command(worker),    solve_list_command(),     compare_command(worker),
          estimate_command(worker), tradeoff_command(worker), bench_command(worker)};
}

}  // namespace capstan
