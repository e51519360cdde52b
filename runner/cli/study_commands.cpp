// The commands that ask the server for a study, or to cancel one.
#include <unistd.h>

#include <iostream>

#include "runner/cli/axis_text.hpp"
#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/progress.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/results/export.hpp"
#include "runner/results/phase_diagram.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::string path_of(const StudyArguments& arguments, const std::string& rest = "") {
  return "/v1/studies/" + arguments.id + rest;
}

}  // namespace

int print_studies(const std::string& server) {
  Table table{{"study", "submitted", "cases", "ended", "progress", "description"}, {}};
  for (const ordered_json& study : Client(server).get_all("/v1/studies", "studies")) {
    const ordered_json& cases = study["cases"];
    const int ended = cases["total"].get<int>() - cases["queued"].get<int>() - cases["running"].get<int>();
    const int percent = static_cast<int>(100 * study["progress"].get<double>());
    table.rows.push_back({study["id"], study["submitted_at"], cases["total"], ended,
                          std::to_string(percent) + " %", study["description"]});
  }
  std::cout << as_text(table);
  return kExitDone;
}

int print_study(const StudyArguments& arguments) {
  const ordered_json study = Client(arguments.server).get(path_of(arguments));
  std::cout << study["id"].get<std::string>() << "  " << study["description"].get<std::string>() << '\n'
            << "submitted " << study["submitted_at"].get<std::string>()
            << (study["cancelled"] ? ", cancelled" : "") << (study["paused"] ? ", paused" : "") << '\n'
            << progress_text(study) << '\n';
  for (const ordered_json& axis : study["axes"])
    std::cout << axis_text(axis["parameter"], axis["values"]) << '\n';
  for (const auto& [motion, count] : study["motions"].items())
    if (count > 0) std::cout << motion << ": " << count << '\n';
  return kExitDone;
}

int print_results(const StudyArguments& arguments) {
  Client client(arguments.server);
  const ordered_json cases = client.get_all(path_of(arguments, "/cases"), "cases");
  if (arguments.format == "json")
    std::cout << ordered_json{{"study", arguments.id}, {"cases", cases}}.dump(2) << '\n';
  else if (arguments.format == "csv")
    std::cout << as_csv(full_table(cases));
  else
    std::cout << as_text(summary_table(client.get(path_of(arguments)), cases));
  return kExitDone;
}

int print_phase_diagram(const StudyArguments& arguments) {
  const ordered_json answer = Client(arguments.server).get(path_of(arguments, "/phase-diagram"));
  std::cout << render(phase_diagram_from_json(answer), isatty(STDOUT_FILENO) == 1);
  return kExitDone;
}

int change_study(const StudyArguments& arguments, const std::string& change, const std::string& body) {
  const ordered_json study = Client(arguments.server).post(path_of(arguments, "/" + change), body);
  std::cout << progress_text(study) << '\n';
  return kExitDone;
}

int explain_case(const StudyArguments& arguments) {
  const ordered_json answer = Client(arguments.server).get("/v1/cases/" + arguments.id + "/why");
  std::cout << answer["state"].get<std::string>() << '\n';
  for (const ordered_json& reason : answer["reasons"]) std::cout << "  " << reason.get<std::string>() << '\n';
  return kExitDone;
}

}  // namespace capstan
