#include "runner/cli/usage_error.hpp"

#include <CLI/CLI.hpp>

#include "solver/case/nearest_word.hpp"

namespace capstan {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The command as typed: "capstan bench".
std::string full_name(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return (parent ? full_name(*parent) + " " : "") + app.get_name();
}

/// A message about the first word of the command line that this command does not know; "" if it knows all.
std::string unknown_word_text(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  const bool takes_commands = !app.get_subcommands({}).empty();
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (word.starts_with('-'))
      return "capstan: " + full_name(app) + " has no option " + name +
             suggestion(name, names_of_options(app));
    if (takes_commands)
      return "capstan: there is no command \"" + full_name(app) + " " + word + "\"" +
             suggestion(word, names_of_commands(app));
    return "capstan: " + full_name(app) + " takes no further argument \"" + word + "\"";
  }
  return "";
}

}  // namespace

std::string usage_error_text(const CLI::App* program, const CLI::Error& error) {
  const CLI::App* app = program;
  std::string text = unknown_word_text(*app);
  while (!app->get_subcommands().empty()) {
    app = app->get_subcommands().front();
    if (text.empty()) text = unknown_word_text(*app);
  }
  if (text.empty()) text = std::string("capstan: ") + error.what();
  return text + "\n" + full_name(*app) + " --help explains it\n";
}

}  // namespace capstan
