#include "runner/cli/configuration_file.hpp"

#include <string>

namespace capstan {
namespace {

/// CLI11 reads a file for the program only, not for one of its commands; its parser of files is public.
void read_options(CLI::App& parser, const std::string& file) {
  for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_file(file)) {
    CLI::Option* option = parser.get_option_no_throw("--" + item.fullname());
    if (!option || option->get_name() == "--config" || option->get_name() == "--help")
      throw CLI::ConfigError(file + ": there is no option " + item.fullname());
    if (option->empty()) option->add_result(item.inputs);
  }
}

}  // namespace

/// The values of the options are converted in the order in which the options were added. So the values of
/// the file are there before any of them is.
void add_configuration_file(CLI::App& parser) {
  parser
      .add_option_function<std::string>(
          "--config", [&parser](const std::string& file) { read_options(parser, file); },
          "a TOML file with options of this command, such as jobs = 200")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
}

}  // namespace capstan
