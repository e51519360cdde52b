// The commands that check or copy a data directory, with or without a running server.
#include <sys/stat.h>

#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/doctor/doctor.hpp"
#include "runner/store/backup.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {

namespace {

using nlohmann::ordered_json;

/// Names of the kinds of findings: for people, and in the JSON document.
struct KindNames {
  const char* text;
  const char* json;
};

KindNames names_of(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::repaired:
      return {"repaired", "mended"};
    case Finding::Kind::note:
      return {"note", "note"};
    case Finding::Kind::error:
      break;
  }
  return {"error", "fault"};
}

}  // namespace

int examine_data(const UpkeepArguments& arguments) {
  int errors = 0;
  ordered_json findings = ordered_json::array();
  for (const Finding& finding : examine(arguments.data, arguments.repair)) {
    const KindNames names = names_of(finding.kind);
    findings.push_back({{"kind", names.json}, {"what", finding.what}});
    if (!arguments.json) std::cout << names.text << ": " << finding.what << '\n';
    if (finding.kind == Finding::Kind::error) ++errors;
  }
  if (arguments.json)
    std::cout << ordered_json{{"faults", errors}, {"findings", findings}}.dump(2) << '\n';
  else if (errors == 0)
    std::cout << "all is well\n";
  return errors == 0 ? kExitDone : kExitError;
}

int back_up(const UpkeepArguments& arguments) {
  umask(077);  // the copy is readable by this user alone, like the database
  back_up_database(arguments.data, arguments.file);
  if (arguments.json)
    std::cout << ordered_json{{"file", arguments.file}}.dump(2) << '\n';
  else
    std::cout << arguments.file << " holds all studies, results and histories\n";
  return kExitDone;
}

}  // namespace capstan
