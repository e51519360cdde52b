// The commands that look after a data directory, with or without a daemon that serves it.
#include <sys/stat.h>

#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/doctor/doctor.hpp"
#include "runner/store/backup.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {

namespace {

const char* to_string(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::mended:
      return "mended";
    case Finding::Kind::note:
      return "note";
    case Finding::Kind::fault:
      break;
  }
  return "fault";
}

}  // namespace

int examine_data(const UpkeepArguments& arguments) {
  int unmended = 0;
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const Finding& finding : examine(arguments.data, arguments.mend)) {
    findings.push_back({{"kind", to_string(finding.kind)}, {"what", finding.what}});
    if (!arguments.json) std::cout << to_string(finding.kind) << ": " << finding.what << '\n';
    if (finding.kind == Finding::Kind::fault) ++unmended;
  }
  if (arguments.json)
    std::cout << nlohmann::ordered_json{{"faults", unmended}, {"findings", findings}}.dump(2) << '\n';
  else if (unmended == 0)
    std::cout << "all is well\n";
  return unmended == 0 ? kExitDone : kExitError;
}

int back_up(const UpkeepArguments& arguments) {
  umask(077);  // the copy is as private as the database
  back_up_database(arguments.data, arguments.file);
  if (arguments.json)
    std::cout << nlohmann::ordered_json{{"file", arguments.file}}.dump(2) << '\n';
  else
    std::cout << arguments.file << " holds all studies, results and histories\n";
  return kExitDone;
}

}  // namespace capstan
