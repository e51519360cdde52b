#pragma once
// Options of a command from a file.
#include <CLI/CLI.hpp>

namespace capstan {

/// Adds --config FILE: a TOML file whose keys are the names of the command's other options. The command line
/// goes first. To be called before those options are added. An unknown key is a usage error.
void add_configuration_file(CLI::App& parser);

}  // namespace capstan
