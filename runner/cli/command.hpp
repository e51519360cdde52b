#pragma once
// One row of the table of commands: its name, its options, and the function that runs it.
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace capstan {

/// A command of `capstan`. Either it has options and runs, or it is a group of subcommands.
struct Command {
  std::string name;
  std::string summary;  ///< one line, for the list of commands
  /// Adds the options to the command's parser. Returns a function that runs the command and returns the exit
  /// code; it is called once the command line is parsed. The function owns the variables that the options
  /// fill in, so it must be kept until then.
  std::function<std::function<int()>(CLI::App& parser)> declare = nullptr;
  std::vector<Command> subcommands = {};  ///< of a group; the `declare` of a group is empty
};

/// Adds one option to a parser. The parser stores the value in a member of the arguments.
template <class Arguments>
using Option = std::function<void(CLI::App& parser, Arguments& arguments)>;

/// A command that fills in its arguments and runs.
/// \param options  in the order in which --help lists them
/// \param footer   last part of --help: exit codes, notes, an example
/// \param run      returns the exit code
template <class Arguments>
Command command(std::string name, std::string summary, std::vector<Option<Arguments>> options,
                std::string footer, std::function<int(const Arguments&)> run) {
  auto declare = [options = std::move(options), footer = std::move(footer),
                  run = std::move(run)](CLI::App& parser) {
    auto arguments = std::make_shared<Arguments>();
    for (const Option<Arguments>& add : options) add(parser, *arguments);
    parser.footer(footer);
    return [arguments, run] { return run(*arguments); };
  };
  return {std::move(name), std::move(summary), std::move(declare)};
}

}  // namespace capstan
