#include "runner/cli/watch.hpp"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "runner/cli/commands.hpp"
#include "runner/cli/progress.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/execute/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

int exit_code_of(const ordered_json& cases) {
  return cases["done"] == cases["total"] ? kExitDone : kExitNoAnswer;
}

void report_failures(Client& client, const std::string& study_id, std::ostream& out) {
  for (const char* state : {"failed", "diverged"}) {
    const std::string path = "/v1/studies/" + study_id + "/cases?state=" + state;
    for (const ordered_json& shown : client.get_all(path, "cases"))
      out << "case " << shown["id"].get<std::string>() << ' ' << state << ": "
          << shown["message"].get<std::string>() << '\n';
  }
}

}  // namespace

int watch_study(Client& client, const std::string& study_id, std::ostream& out, bool is_terminal) {
  constexpr std::chrono::milliseconds kInterval{500};
  ProgressLine line(out, is_terminal);
  for (;; std::this_thread::sleep_for(kInterval)) {
    const ordered_json study = client.get("/v1/studies/" + study_id);
    line.show(study);
    const ordered_json& cases = study["cases"];
    if (cases["queued"] > 0 || cases["running"] > 0) continue;
    line.finish();
    report_failures(client, study_id, out);
    return exit_code_of(cases);
  }
}

int watch_study(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::string id = study_id(client, arguments.ids.front());
  std::ostream& out = arguments.json ? std::cerr : std::cout;
  const int code = watch_study(client, id, out, isatty(arguments.json ? STDERR_FILENO : STDOUT_FILENO) == 1);
  if (arguments.json) std::cout << client.get("/v1/studies/" + id).dump(2) << '\n';
  return code;
}

}  // namespace capstan
