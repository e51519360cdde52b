#include "runner/cli/program.hpp"

#include <exception>
#include <iostream>
#include <vector>

#include "runner/cli/commands.hpp"
#include "runner/execute/exit_code.hpp"

namespace capstan {
namespace {

struct Command {
  const char* name;
  const char* summary;
  Action (*declare)(CLI::App&);
};

constexpr Command kCommands[] = {
    {"validate", "check a study file; every fault is reported", declare_validate},
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
    CLI::App* parser = app.add_subcommand("solve", "run one case, or resume it, without a server");
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
  } catch (const std::exception& error) {
    std::cerr << "capstan: " << error.what() << '\n';
    return kExitError;
  }
}

}  // namespace capstan
