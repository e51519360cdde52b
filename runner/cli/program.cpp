#include "runner/cli/program.hpp"

#include <exception>
#include <iostream>
#include <vector>

#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/execute/exit_code.hpp"

namespace capstan {
namespace {

struct Command {
  const char* name;
  const char* summary;
  Action (*declare)(CLI::App&);
};

constexpr Command kCommands[] = {
    {"serve", "run the server: takes studies, computes their cases, answers over HTTP", declare_serve},
    {"validate", "check a study file; every fault is reported", declare_validate},
    {"submit", "hand a study to the server", declare_submit},
    {"studies", "list all studies, the newest first", declare_studies},
    {"show", "one study: its axes, progress and motions", declare_show},
    {"watch", "show the progress of a study until all its cases have ended", declare_watch},
    {"results", "the cases of a study and what came of them", declare_results},
    {"phase-diagram", "the motion over two axes of a study", declare_phase_diagram},
    {"cancel", "take a study's cases back", declare_cancel},
};

/// Reads the arguments; the exit code is in `code` when there is nothing to run (help, or a usage error).
Action parse_arguments(int argc, char** argv, const SolveCase& solve, int& code) {
  CLI::App app{"Capstan: do capsules in shear flow tumble or tank-tread, and how do they deform?", "capstan"};
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Command& command : kCommands) {
    CLI::App* parser = app.add_subcommand(command.name, command.summary);
    actions.emplace_back(parser, command.declare(*parser));
  }
  if (solve) {
    CLI::App* parser = app.add_subcommand("solve", "compute one case, or resume it, without a server");
    actions.emplace_back(parser, declare_solve(*parser, solve));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    code = app.exit(error) == 0 ? kExitDone : kExitInvalidInput;
    return nullptr;
  }
  for (auto& [parser, action] : actions)
    if (parser->parsed()) return action;
  return nullptr;
}

}  // namespace

int run_program(int argc, char** argv, const SolveCase& solve) {
  try {
    int code = kExitDone;
    const Action action = parse_arguments(argc, argv, solve, code);
    return action ? action() : code;
  } catch (const Refused& refusal) {
    std::cerr << "capstan: " << refusal.what() << '\n';
    if (!refusal.issues.empty()) print_issues(std::cerr, "the server", refusal.issues);
    return refusal.status == 404 ? kExitNotFound : kExitInvalidInput;
  } catch (const Unreachable& error) {
    std::cerr << "capstan: " << error.what() << '\n';
    return kExitUnreachable;
  } catch (const std::invalid_argument& error) {
    std::cerr << "capstan: " << error.what() << '\n';
    return kExitInvalidInput;
  } catch (const std::exception& error) {
    std::cerr << "capstan: " << error.what() << '\n';
    return kExitError;
  }
}

}  // namespace capstan
