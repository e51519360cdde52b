#pragma once
// Options that several commands share. Each is a function of a parser and of arguments that have the member
// named below.
#include <CLI/CLI.hpp>

namespace capstan::options {

/// --server: the member `server`
inline constexpr auto server = [](CLI::App& parser, auto& arguments) {
  parser.add_option("--server", arguments.server, "the server to ask; https:// where a proxy adds it")
      ->type_name("URL")
      ->envname("CAPSTAN_SERVER")
      ->capture_default_str();
};

/// --json: the member `json`
inline constexpr auto json = [](CLI::App& parser, auto& arguments) {
  parser.add_flag("--json", arguments.json, "print one JSON document instead of text");
};

/// --data: the member `data`, of a directory that exists
inline constexpr auto data = [](CLI::App& parser, auto& arguments) {
  parser.add_option("--data", arguments.data, "the data directory of a server")
      ->type_name("DIR")
      ->capture_default_str();
};

/// ID...: the member `ids`, of a command that treats each of several studies alike
inline constexpr auto study_ids = [](CLI::App& parser, auto& arguments) {
  parser
      .add_option("ID", arguments.ids,
                  "the study, or several: its id, a beginning that no other id has, or its name")
      ->required();
};

/// FILE: the member `file`. \param description  of the file, for --help
inline auto file(const char* description) {
  return [description](CLI::App& parser, auto& arguments) {
    parser.add_option("FILE", arguments.file, description)->required();
  };
}

/// --cores: the member `cores`. \param description  for --help
inline auto cores(const char* description) {
  return [description](CLI::App& parser, auto& arguments) {
    parser.add_option("--cores", arguments.cores, description)
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
  };
}

}  // namespace capstan::options
