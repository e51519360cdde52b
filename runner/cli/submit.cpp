#include <unistd.h>

#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/cli/study_text.hpp"
#include "runner/cli/watch.hpp"
#include "runner/render/printable.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {

/// Only the id goes to standard output, for scripts; messages and progress go to standard error.
int submit_study_file(const SubmitArguments& arguments) {
  const auto study = read_study_file(arguments.file);
  if (!study) return kExitInvalidInput;
  Client client(arguments.server);
  nlohmann::ordered_json submitted = client.post("/v1/studies", study->document.dump());
  const std::string id = submitted["id"];
  if (!arguments.json) std::cout << id << std::endl;
  for (const nlohmann::ordered_json& warning : submitted["warnings"])
    std::cerr << "warning: " << printable(warning.get<std::string>()) << '\n';
  if (submitted.value("resumed", false)) std::cerr << "the study was paused, and is resumed\n";
  std::cerr << notes_text(submitted["notes"]);
  const int code =
      arguments.watch ? watch_study(client, id, std::cerr, isatty(STDERR_FILENO) == 1) : kExitDone;
  if (arguments.json)
    std::cout << (arguments.watch ? client.get(path_of_study(id)) : submitted).dump(2) << '\n';
  return code;
}

}  // namespace capstan
