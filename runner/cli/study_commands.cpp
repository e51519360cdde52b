// The commands that ask the server for a study, or to cancel one.
#include <unistd.h>

#include <iostream>
#include <memory>

#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/progress.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/results/export.hpp"
#include "runner/results/phase_diagram.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

struct StudyArguments {
  std::string id, format = "table", server = kDefaultServer;
  std::string path(const std::string& rest = "") const { return "/v1/studies/" + id + rest; }
};

std::shared_ptr<StudyArguments> declare_study_arguments(CLI::App& command, const std::string& example) {
  auto arguments = std::make_shared<StudyArguments>();
  command.add_option("ID", arguments->id, "the study")->required();
  add_server_option(command, arguments->server);
  command.footer("Example:\n  capstan " + example + "\n");
  return arguments;
}

int list_studies(const std::string& server) {
  const ordered_json answer = Client(server).get("/v1/studies");
  Table table{{"study", "submitted", "cases", "ended", "progress", "description"}, {}};
  for (const ordered_json& study : answer["studies"]) {
    const ordered_json& cases = study["cases"];
    const int ended = cases["total"].get<int>() - cases["queued"].get<int>() - cases["running"].get<int>();
    const int percent = static_cast<int>(100 * study["progress"].get<double>());
    table.rows.push_back({study["id"], study["submitted_at"], cases["total"], ended,
                          std::to_string(percent) + " %", study["description"]});
  }
  std::cout << as_text(table);
  return kExitDone;
}

int show(const StudyArguments& arguments) {
  const ordered_json study = Client(arguments.server).get(arguments.path());
  std::cout << study["id"].get<std::string>() << "  " << study["description"].get<std::string>() << '\n'
            << "submitted " << study["submitted_at"].get<std::string>()
            << (study["cancelled"] ? ", cancelled\n" : "\n") << progress_text(study) << '\n';
  for (const ordered_json& axis : study["axes"]) {
    std::cout << axis["parameter"].get<std::string>() << ':';
    for (const ordered_json& value : axis["values"]) std::cout << ' ' << plain(value);
    std::cout << '\n';
  }
  for (const auto& [motion, count] : study["motions"].items())
    if (count > 0) std::cout << motion << ": " << count << '\n';
  return kExitDone;
}

int results(const StudyArguments& arguments) {
  Client client(arguments.server);
  const ordered_json answer = client.get(arguments.path("/cases"));
  if (arguments.format == "json")
    std::cout << answer.dump(2) << '\n';
  else if (arguments.format == "csv")
    std::cout << as_csv(full_table(answer["cases"]));
  else
    std::cout << as_text(summary_table(client.get(arguments.path()), answer["cases"]));
  return kExitDone;
}

int draw_phase_diagram(const StudyArguments& arguments) {
  const ordered_json answer = Client(arguments.server).get(arguments.path("/phase-diagram"));
  std::cout << render(phase_diagram_from_json(answer), isatty(STDOUT_FILENO) == 1);
  return kExitDone;
}

int cancel(const StudyArguments& arguments) {
  const ordered_json study = Client(arguments.server).post(arguments.path("/cancel"), "");
  std::cout << progress_text(study) << '\n';
  return kExitDone;
}

}  // namespace

Action declare_studies(CLI::App& command) {
  auto server = std::make_shared<std::string>(kDefaultServer);
  add_server_option(command, *server);
  return [server] { return list_studies(*server); };
}

Action declare_show(CLI::App& command) {
  const auto arguments = declare_study_arguments(command, "show quickstart-3f9c");
  return [arguments] { return show(*arguments); };
}

Action declare_results(CLI::App& command) {
  const auto arguments =
      declare_study_arguments(command, "results quickstart-3f9c --format csv > quickstart.csv");
  command
      .add_option("--format", arguments->format,
                  "table: what varies and what came of it; csv, json: everything")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->capture_default_str();
  return [arguments] { return results(*arguments); };
}

Action declare_phase_diagram(CLI::App& command) {
  const auto arguments = declare_study_arguments(command, "phase-diagram quickstart-3f9c");
  return [arguments] { return draw_phase_diagram(*arguments); };
}

Action declare_cancel(CLI::App& command) {
  const auto arguments = declare_study_arguments(command, "cancel quickstart-3f9c");
  return [arguments] { return cancel(*arguments); };
}

}  // namespace capstan
