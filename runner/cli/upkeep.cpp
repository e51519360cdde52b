// The commands that look after a data directory, with or without a daemon that serves it.
#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/queue/database.hpp"
#include "runner/service/doctor.hpp"

namespace capstan {

int examine_data(const UpkeepArguments& arguments) {
  int unmended = 0;
  for (const Finding& finding : examine(arguments.data, arguments.mend)) {
    std::cout << (finding.is_mended ? "mended: " : "fault: ") << finding.what << '\n';
    if (!finding.is_mended) ++unmended;
  }
  if (unmended == 0) std::cout << "all is well\n";
  return unmended == 0 ? kExitDone : kExitError;
}

int back_up(const UpkeepArguments& arguments) {
  Database database(std::filesystem::path(arguments.data) / "capstan.sqlite", Database::Access::read);
  database.copy_to(arguments.file);
  std::cout << arguments.file << " holds all studies, results and histories\n";
  return kExitDone;
}

}  // namespace capstan
