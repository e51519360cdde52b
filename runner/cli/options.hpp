#pragma once
// Options that several commands share. Each of these adds one option to a parser, which stores the value in
// the named member of the command's arguments.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace capstan::options {

/// --server, stored in `server`.
inline constexpr auto server = [](CLI::App& parser, auto& arguments) {
  parser.add_option("--server", arguments.server, "the server to ask; https:// where a proxy adds it")
      ->type_name("URL")
      ->envname("CAPSTAN_SERVER")
      ->capture_default_str();
};

/// --json, stored in `json`.
inline constexpr auto json = [](CLI::App& parser, auto& arguments) {
  parser.add_flag("--json", arguments.json, "print one JSON document instead of text");
};

/// --data, stored in `data`. The directory must exist.
inline constexpr auto data = [](CLI::App& parser, auto& arguments) {
  parser.add_option("--data", arguments.data, "the data directory of a server")
      ->type_name("DIR")
      ->capture_default_str();
};

/// ID..., stored in `ids`: the studies that the command treats alike.
inline constexpr auto study_ids = [](CLI::App& parser, auto& arguments) {
  parser
      .add_option("ID", arguments.ids,
                  "the study, or several: its id, a beginning that no other id has, or its name")
      ->required();
};

/// FILE, stored in `file`.
/// \param description  of the file, for --help
inline auto file(const char* description) {
  return [description](CLI::App& parser, auto& arguments) {
    parser.add_option("FILE", arguments.file, description)->required();
  };
}

/// --out, stored in `out`: a file to write. Its folder must exist.
/// \param description  of the file, for --help
inline auto output_file(const char* description) {
  return [description](CLI::App& parser, auto& arguments) {
    const auto issue_of_folder = [](const std::string& out) {
      const std::filesystem::path folder = std::filesystem::absolute(out).parent_path();
      return std::filesystem::is_directory(folder)
                 ? ""
                 : "cannot write " + out + ": there is no folder " + folder.string();
    };
    parser.add_option("-o,--out", arguments.out, description)
        ->type_name("FILE")
        ->required()
        ->check(CLI::Validator(issue_of_folder, ""));
  };
}

/// --cores, stored in `cores`.
/// \param description  for --help
inline auto cores(const char* description) {
  return [description](CLI::App& parser, auto& arguments) {
    parser.add_option("--cores", arguments.cores, description)
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
  };
}

}  // namespace capstan::options
