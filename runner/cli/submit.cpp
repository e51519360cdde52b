#include <unistd.h>

#include <iostream>
#include <memory>

#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/cli/watch.hpp"
#include "runner/execute/exit_code.hpp"

namespace capstan {
namespace {

struct SubmitArguments {
  std::string file, server = kDefaultServer;
  bool watch = false;
};

/// The id alone goes to standard output, so that scripts can take it.
int submit(const SubmitArguments& arguments) {
  const auto study = read_study_file(arguments.file);
  if (!study) return kExitInvalidInput;
  Client client(arguments.server);
  const std::string id = client.post("/v1/studies", study->document.dump())["id"];
  std::cout << id << std::endl;
  return arguments.watch ? watch_study(client, id, std::cerr, isatty(STDERR_FILENO) == 1) : kExitDone;
}

}  // namespace

Action declare_submit(CLI::App& command) {
  auto arguments = std::make_shared<SubmitArguments>();
  command.add_option("FILE", arguments->file, "the study")->required();
  command.add_flag("--watch", arguments->watch, "show the progress until all cases have ended");
  add_server_option(command, arguments->server);
  command.footer(
      "Prints the study's id. The same study again is the same id, and nothing is computed twice.\n"
      "Example:\n  capstan submit studies/quickstart/study.json --watch\n");
  return [arguments] { return submit(*arguments); };
}

}  // namespace capstan
