#include "runner/cli/program.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/standard_output.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/cli/usage_error.hpp"
#include "runner/render/bench_report.hpp"
#include "runner/render/printable.hpp"
#include "runner/study/input_file.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/exit_code.hpp"
#include "solver/run_directory/parent_daemon.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {
namespace {

using Action = std::function<int()>;

void add_server_option(CLI::App& command, std::string& server) {
  command.add_option("--server", server, "the server to ask; https:// where a proxy adds it")
      ->type_name("URL")
      ->envname("CAPSTAN_SERVER")
      ->capture_default_str();
}

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print one JSON document instead of text");
}

/// The ids of a command that does the same with each of several studies.
void add_study_ids(CLI::App& command, std::vector<std::string>& ids) {
  command
      .add_option("ID", ids, "the study, or several: its id, a beginning that no other id has, or its name")
      ->required();
}

Action declare_serve(CLI::App& command) {
  auto arguments = std::make_shared<ServeArguments>();
  command.add_option("--data", arguments->data, "where everything is kept; made if it is not there")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--listen", arguments->listen, "an address of this machine; port 0 takes any free one")
      ->type_name("HOST:PORT")
      ->capture_default_str();
  command
      .add_option("--host", arguments->hosts,
                  "a name under which clients ask, besides localhost and addresses")
      ->type_name("NAME");
  command.add_option("--cores", arguments->cores, "cases that run side by side")
      ->check(CLI::Range(1, 1024))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--memory", arguments->memory_mb, "megabytes that a case may take; without it, all")
      ->check(CLI::PositiveNumber)
      ->type_name("MB");
  command
      .add_option("--wall-time", arguments->wall_seconds, "seconds that an attempt may take; without it, any")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  command.add_option("--lease", arguments->lease_seconds, "seconds that a process may stand still")
      ->check(CLI::Range(1, 86400))
      ->type_name("S")
      ->capture_default_str();
  command.footer(
      "Ctrl-C or SIGTERM: running cases write a checkpoint, and the next start goes on from there.\n"
      "A token in the environment (CAPSTAN_TOKEN, or a file named by CAPSTAN_TOKEN_FILE) is asked of every "
      "client;\n"
      "addresses that other machines can reach need one.\n"
      "Example:\n  capstan serve --data /srv/capsules --cores 4\n");
  return [arguments] { return serve(*arguments); };
}

void add_data_option(CLI::App& command, std::string& data) {
  command.add_option("--data", data, "the data directory of a server")
      ->type_name("DIR")
      ->capture_default_str();
}

Action declare_doctor(CLI::App& command) {
  auto arguments = std::make_shared<UpkeepArguments>();
  add_data_option(command, arguments->data);
  command.add_flag("--repair", arguments->mend,
                   "mend what can be mended without losing anything; stop the server first");
  add_json_flag(command, arguments->json);
  command.footer(
      "Exit code 0: all is well, mended, or needs nothing (a note). 1: some faults are left.\n"
      "Example:\n  capstan doctor --data /srv/capsules\n");
  return [arguments] { return examine_data(*arguments); };
}

Action declare_backup(CLI::App& command) {
  auto arguments = std::make_shared<UpkeepArguments>();
  command.add_option("FILE", arguments->file, "the copy; an earlier one is replaced")->required();
  add_data_option(command, arguments->data);
  add_json_flag(command, arguments->json);
  command.footer(
      "The server may be running. To go back to the copy, put it into an empty data directory as "
      "capstan.sqlite.\n"
      "Shapes and checkpoints stand in runs/, whose files are only ever replaced whole: copy it with any "
      "tool.\n"
      "Example:\n  capstan backup capsules.sqlite --data /srv/capsules\n");
  return [arguments] { return back_up(*arguments); };
}

Action declare_disk(CLI::App& command) {
  auto arguments = std::make_shared<UpkeepArguments>();
  add_data_option(command, arguments->data);
  add_json_flag(command, arguments->json);
  command.footer(
      "The server may be running. A case of two studies counts in both, and once in the sum.\n"
      "Example:\n  capstan disk --data /srv/capsules\n");
  return [arguments] { return print_disk_usage(*arguments); };
}

Action declare_validate(CLI::App& command) {
  auto arguments = std::make_shared<FileArguments>();
  command.add_option("FILE", arguments->file, "the study or case; - is standard input")->required();
  add_json_flag(command, arguments->json);
  command.footer(
      "All faults are reported at once, each with its place in the file. Nothing is computed.\n"
      "Example:\n  capstan validate studies/quickstart/study.json\n");
  return [arguments] { return validate_file(*arguments); };
}

Action declare_submit(CLI::App& command) {
  auto arguments = std::make_shared<SubmitArguments>();
  command.add_option("FILE", arguments->file, "the study; - is standard input")->required();
  command.add_flag("--watch", arguments->watch, "show the progress until all cases have ended");
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer(
      "Prints the study's id. The same study again is the same id, and nothing is computed twice.\n"
      "Example:\n  capstan submit studies/quickstart/study.json --watch\n");
  return [arguments] { return submit_study(*arguments); };
}

Action declare_studies(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer(
      "A study is queued, running, paused, done (all its cases have ended) or cancelled.\n"
      "Example:\n  capstan studies\n");
  return [arguments] { return print_studies(*arguments); };
}

Action declare_show(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan show quickstart-3f9c\n");
  return [arguments] { return print_study(*arguments); };
}

Action declare_watch(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  command.add_flag("--json", arguments->json,
                   "print the study as JSON at the end; the progress goes to standard error");
  add_server_option(command, arguments->server);
  command.footer(
      "Several studies are watched one after another.\n"
      "Exit code 0: all cases are done. 3: some have no answer.\n"
      "Example:\n  capstan watch quickstart-3f9c\n");
  return [arguments] { return watch_study(*arguments); };
}

Action declare_results(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  auto* format = command
                     .add_option("--format", arguments->format,
                                 "table: what varies, what came of it; csv, json: everything")
                     ->check(CLI::IsMember({"table", "csv", "json"}))
                     ->capture_default_str();
  command.add_flag("--json", arguments->json, "the same as --format json")->excludes(format);
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan results quickstart-3f9c --format csv > quickstart.csv\n");
  return [arguments] { return print_results(*arguments); };
}

Action declare_phase_diagram(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  command.add_option("--x", arguments->x, "the axis to draw across; by default the first")->type_name("AXIS");
  command.add_option("--y", arguments->y, "the axis to draw upwards; by default the next")->type_name("AXIS");
  command.add_option("--at", arguments->at, "the value at which another axis is fixed, once an axis")
      ->type_name("AXIS=VALUE")
      ->allow_extra_args(false);
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer(
      "In colours on a terminal, unless the environment has NO_COLOR.\n"
      "Example:\n  capstan phase-diagram quickstart-3f9c\n"
      "  capstan phase-diagram sweep-81cc --x Ca --y V --at E_b=0.015\n");
  return [arguments] { return print_phase_diagram(*arguments); };
}

/// A command that changes studies, by its own name.
Action declare_change(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan " + command.get_name() + " quickstart-3f9c\n");
  return [arguments, change = command.get_name()] { return change_study(*arguments, change); };
}

Action declare_delete(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  add_study_ids(command, arguments->ids);
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer(
      "Results, histories and shapes of its cases are deleted, too, unless another study has the same case; "
      "cases "
      "that\nrun are stopped. To have them back, they must be computed again. Give the whole id or the "
      "study's name.\n"
      "Example:\n  capstan delete quickstart-3f9c\n");
  return [arguments] { return delete_study(*arguments); };
}

Action declare_retry(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  auto fidelity = std::make_shared<std::optional<std::string>>();
  add_study_ids(command, arguments->ids);
  command
      .add_option("--fidelity", *fidelity, "compute the failed and diverged cases at this one, as \"fine\"")
      ->type_name("PRESET");
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan retry quickstart-3f9c --fidelity fine\n");
  return [arguments, fidelity] {
    if (!*fidelity) return change_study(*arguments, "retry");
    return change_study(*arguments, "retry", nlohmann::json{{"fidelity", **fidelity}}.dump());
  };
}

/// The last of the words; the others are the studies.
int take_priority(std::vector<std::string>& words) {
  constexpr int kMax = 100;
  const std::string typed = words.back();
  words.pop_back();
  int priority = 0;
  const auto read = std::from_chars(typed.data(), typed.data() + typed.size(), priority);
  const bool is_read = read.ec == std::errc() && read.ptr == typed.data() + typed.size();
  if (!is_read || std::abs(priority) > kMax)
    throw std::invalid_argument("the priority must be a whole number from -100 to 100, is \"" + typed + "\"");
  if (words.empty())
    throw std::invalid_argument("name the study before the priority: capstan priority ID " + typed);
  return priority;
}

Action declare_priority(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  command
      .add_option("ID", arguments->ids,
                  "the study, or several: its id, a beginning that no other id has, or its name; then the "
                  "priority N from -100 to 100, 0 at first")
      ->type_name("N")
      ->required();
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan priority quickstart-3f9c 10\n");
  return [arguments] {
    const int priority = take_priority(arguments->ids);
    return change_study(*arguments, "priority", "{\"priority\": " + std::to_string(priority) + "}");
  };
}

Action declare_why(CLI::App& command) {
  auto arguments = std::make_shared<StudyArguments>();
  command
      .add_option(
          "ID", arguments->ids,
          "the study or case, or several: its id, a beginning that no other id has, or a study's name")
      ->required();
  add_json_flag(command, arguments->json);
  add_server_option(command, arguments->server);
  command.footer(
      "Of a study: how many of its cases wait, run or have ended, and for which reasons.\n"
      "Example:\n  capstan why quickstart-3f9c\n");
  return [arguments] { return explain(*arguments); };
}

Action declare_solve(CLI::App& command, const Physics& physics) {
  struct Arguments {
    std::filesystem::path file, out;
    double wall_seconds = std::numeric_limits<double>::infinity();
    bool json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  command.add_option("CASE", arguments->file, "the case (schema/case.schema.json); - is standard input")
      ->required();
  command.add_option("--out", arguments->out, "the run directory; made if it is not there")->required();
  command
      .add_option(
          "--wall-time", arguments->wall_seconds,
          "seconds after which it stops with a checkpoint (exit code 75); without it, it runs to its end")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  command.add_flag("--json", arguments->json, "print the run's result.json at the end");
  command.footer(
      "A run that was killed goes on where it stood when the same command is given again.\n"
      "Example:\n  capstan solve case.json --out runs/first\n");
  return [arguments, solve = physics.solve] {
    end_with_daemon();
    const int code = solve(arguments->file, arguments->out, arguments->wall_seconds);
    if (arguments->json && (code == kExitDone || code == kExitNoAnswer))
      std::cout << read_input(RunDirectory(arguments->out).result_file());
    return code;
  };
}

Action declare_compare(CLI::App& command, const Physics& physics) {
  struct Arguments {
    std::vector<std::filesystem::path> files;
    bool json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  command
      .add_option(
          "CASE", arguments->files,
          "the cases (schema/case.schema.json), - is standard input; their fluid and grid are set here")
      ->required();
  add_json_flag(command, arguments->json);
  command.footer(
      "Prints D_xy and theta at the end of each run, and what is left between the models without spacing and "
      "walls.\n"
      "Example:\n  capstan compare studies/cross_validation/*.json\n");
  return [arguments, compare = physics.compare] { return compare(arguments->files, arguments->json); };
}

Action declare_estimate(CLI::App& command, const Physics& physics) {
  struct Arguments {
    std::string file;
    int cores = usable_cores();
    bool json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  command.add_option("FILE", arguments->file, "the study; - is standard input")->required();
  command.add_option("--cores", arguments->cores, "cases that will run side by side")
      ->check(CLI::Range(1, 1024))
      ->type_name("N")
      ->capture_default_str();
  add_json_flag(command, arguments->json);
  command.footer(
      "Runs some of the cases for a moment, two seconds in all; nothing is submitted.\n"
      "Example:\n  capstan estimate studies/fig17/study.json\n");
  return [arguments, estimate = physics.estimate] {
    const auto study = read_study_file(arguments->file);
    return study ? estimate(*study, arguments->cores, arguments->json) : kExitInvalidInput;
  };
}

/// One of the measurements below `capstan bench`.
Action declare_benchmark(CLI::App& command, const Benchmark& benchmark) {
  auto json = std::make_shared<bool>(false);
  add_json_flag(command, *json);
  command.footer("Takes " + benchmark.duration +
                 " on a quiet machine. Threads: OMP_NUM_THREADS, or all cores.\nExample:\n  capstan bench " +
                 benchmark.name + "\n");
  return [json, benchmark] {
    std::cerr << "capstan bench " << benchmark.name << " takes " << benchmark.duration << std::endl;
    BenchReport report(std::cout, *json);
    benchmark.run(report);
    report.finish();
    return kExitDone;
  };
}

struct Command {
  const char* name;
  const char* summary;
  Action (*declare)(CLI::App&);
};

constexpr Command kCommands[] = {
    {"serve", "run the server: takes studies, computes their cases, answers over HTTP", declare_serve},
    {"doctor", "check a data directory: the database, the run directories, the disk", declare_doctor},
    {"backup", "copy the database, also of a running server", declare_backup},
    {"disk", "what takes space in a data directory, study by study", declare_disk},
    {"validate", "check the file of a study or a case; every fault is reported", declare_validate},
    {"submit", "hand a study to the server", declare_submit},
    {"studies", "list all studies, the newest first", declare_studies},
    {"show", "one study: its axes, progress and motions", declare_show},
    {"watch", "show the progress of a study until all its cases have ended", declare_watch},
    {"results", "the cases of a study and what came of them", declare_results},
    {"phase-diagram", "the motion over two axes of a study", declare_phase_diagram},
    {"cancel", "take back what a study has not computed yet", declare_change},
    {"delete", "delete a study and the results that no other study has", declare_delete},
    {"pause", "start no more cases of a study; what runs goes on", declare_change},
    {"resume", "start cases of a paused study again", declare_change},
    {"retry", "queue the failed cases of a study again, at a finer setting if asked", declare_retry},
    {"priority", "the studies of the highest number come first, equals take turns", declare_priority},
    {"why", "what a case or the cases of a study wait for, or why they are where they are", declare_why},
};

std::string version_text(const std::string& revision) {
  std::string text = "capstan " CAPSTAN_VERSION "\nnumerics " + std::to_string(kNumericsVersion);
  if (!revision.empty()) text += "\nrevision " + revision;
  return text;
}

/// What the arguments ask for; nothing, and the exit code in `code`, after help or a usage error.
Action read_arguments(int argc, char** argv, const Physics& physics, int& code) {
  CLI::App app{"Capstan: do capsules in shear flow tumble or tank-tread, and how do they deform?", "capstan"};
  app.require_subcommand(1);
  app.set_version_flag(
      "--version", [&] { return version_text(physics.revision); },
      "print the versions of program and numerics");
  app.failure_message(usage_fault);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Command& command : kCommands) {
    CLI::App* parser = app.add_subcommand(command.name, command.summary);
    actions.emplace_back(parser, command.declare(*parser));
  }
  CLI::App* solve = app.add_subcommand("solve", "compute one case, or resume it, without a server");
  actions.emplace_back(solve, declare_solve(*solve, physics));
  CLI::App* compare =
      app.add_subcommand("compare", "run the same case with all fluid models and tell how far they agree");
  actions.emplace_back(compare, declare_compare(*compare, physics));
  CLI::App* estimate =
      app.add_subcommand("estimate", "how long a study takes on this machine, before it is submitted");
  actions.emplace_back(estimate, declare_estimate(*estimate, physics));
  CLI::App* bench = app.add_subcommand("bench", "measure how fast the solver is on this machine");
  bench->require_subcommand(1);
  for (const Benchmark& benchmark : physics.benchmarks) {
    CLI::App* parser = bench->add_subcommand(benchmark.name, benchmark.summary);
    actions.emplace_back(parser, declare_benchmark(*parser, benchmark));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    code = app.exit(error) == 0 ? kExitDone : kExitInvalidInput;
    return nullptr;
  }
  for (auto& [command, action] : actions)
    if (command->parsed()) return action;
  return nullptr;
}

int report(const std::exception& error, int code) {
  std::cerr << "capstan: " << printable(error.what()) << '\n';
  return code;
}

int exit_code_of(const Refused& refusal) {
  if (refusal.status >= 500) return kExitError;
  return refusal.status == 404 ? kExitNotFound : kExitInvalidInput;
}

int run(int argc, char** argv, const Physics& physics) {
  try {
    int code = kExitDone;
    const Action action = read_arguments(argc, argv, physics, code);
    return action ? action() : code;
  } catch (const Refused& refusal) {
    if (!refusal.issues.empty()) print_issues(std::cerr, "the server", refusal.issues);
    return report(refusal, exit_code_of(refusal));
  } catch (const Unreachable& error) {
    return report(error, kExitUnreachable);
  } catch (const std::invalid_argument& error) {
    return report(error, kExitInvalidInput);
  } catch (const std::exception& error) {
    return report(error, kExitError);
  }
}

}  // namespace

int run_program(int argc, char** argv, const Physics& physics) {
  occupy_closed_streams();
  const int code = run(argc, argv, physics);
  return output_has_arrived() || code != kExitDone ? code : kExitError;
}

}  // namespace capstan
