#include "runner/cli/program.hpp"

#include <exception>
#include <iostream>
#include <utility>

#include "runner/cli/client.hpp"
#include "runner/cli/command_table.hpp"
#include "runner/cli/standard_output.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/cli/usage_error.hpp"
#include "runner/render/printable.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/attempt_token.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

/// A command's parser and the function that runs the command.
using Action = std::pair<CLI::App*, std::function<int()>>;

void add_command(CLI::App& parent, const Command& command, std::vector<Action>& actions) {
  CLI::App* parser = parent.add_subcommand(command.name, command.summary);
  if (command.declare) {
    actions.emplace_back(parser, command.declare(*parser));
    return;
  }
  parser->require_subcommand(1);
  for (const Command& subcommand : command.subcommands) add_command(*parser, subcommand, actions);
}

std::string version_text(const std::string& revision) {
  std::string text = "capstan " CAPSTAN_VERSION "\nnumerics " + std::to_string(kNumericsVersion);
  if (!revision.empty()) text += "\nrevision " + revision;
  return text;
}

/// Parses the command line and runs the command; --help and usage errors end here.
int parse_and_run(int argc, char** argv, const WorkerCommands& worker) {
  CLI::App app{"Capstan: do capsules in shear flow tumble or tank-tread, and how do they deform?", "capstan"};
  app.require_subcommand(1);
  app.set_version_flag(
      "--version", [&] { return version_text(worker.revision); },
      "print the versions of program and numerics");
  app.failure_message(usage_error_text);
  std::vector<Action> actions;
  for (const auto& rows : {data_commands(), study_commands(), worker_commands(worker)})
    for (const Command& command : rows) add_command(app, command, actions);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitDone : kExitInvalidInput;
  }
  for (const auto& [parser, run] : actions)
    if (parser->parsed()) return run();
  return kExitDone;
}

int report(const std::exception& error, int code) {
  std::cerr << "capstan: " << printable(error.what()) << '\n';
  return code;
}

int exit_code_of(const Refused& refusal) {
  if (refusal.status >= 500) return kExitError;
  return refusal.status == 404 ? kExitNotFound : kExitInvalidInput;
}

/// Exceptions become messages on standard error and exit codes.
int run_reporting_errors(int argc, char** argv, const WorkerCommands& worker) {
  try {
    return parse_and_run(argc, argv, worker);
  } catch (const Refused& refusal) {
    if (!refusal.issues.empty()) print_issues(std::cerr, "the server", refusal.issues);
    return report(refusal, exit_code_of(refusal));
  } catch (const Unreachable& error) {
    return report(error, kExitUnreachable);
  } catch (const std::invalid_argument& error) {
    return report(error, kExitInvalidInput);
  } catch (const AttemptWithdrawn& error) {
    return report(error, kExitInterrupted);
  } catch (const std::exception& error) {
    return report(error, kExitError);
  }
}

}  // namespace

int run_program(int argc, char** argv, const WorkerCommands& worker) {
  occupy_closed_streams();
  const int code = run_reporting_errors(argc, argv, worker);
  const bool is_printed = flush_standard_output();
  return is_printed || code != kExitDone ? code : kExitError;
}

}  // namespace capstan
