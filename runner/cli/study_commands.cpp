// The commands that ask the server about studies and change nothing.
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "runner/cli/answers.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/cli/study_text.hpp"
#include "runner/cli/write_results.hpp"
#include "runner/render/boundary_table.hpp"
#include "runner/render/phase_diagram_text.hpp"
#include "runner/render/printable.hpp"
#include "runner/render/table.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::multimap<std::string, std::string> section_query(const StudyArguments& arguments) {
  std::multimap<std::string, std::string> query;
  if (!arguments.x.empty()) query.emplace("x", arguments.x);
  if (!arguments.y.empty()) query.emplace("y", arguments.y);
  for (const std::string& fixed : arguments.at) query.emplace("at", fixed);
  return query;
}

/// True on a terminal, unless NO_COLOR is set (https://no-color.org).
bool colours_are_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) == 1 && (!no_color || *no_color == '\0');
}

/// \param reason  for a case a sentence; for a study an object with a sentence and the number of cases to
///                which it applies
std::string reason_text(const ordered_json& reason) {
  if (reason.is_string()) return printable(reason.get<std::string>());
  return cases_text(reason["cases"].get<std::int64_t>()) + ": " +
         printable(reason["reason"].get<std::string>());
}

Table table_of_studies(const ordered_json& studies) {
  Table table{{"study", "state", "submitted", "cases", "ended", "progress", "description"}, {}};
  for (const ordered_json& study : studies) {
    const ordered_json& cases = study["cases"];
    const int ended = cases["total"].get<int>() - cases["queued"].get<int>() - cases["running"].get<int>();
    const int percent = static_cast<int>(100 * study["progress"].get<double>());
    table.rows.push_back({study["id"], study["state"], study["submitted_at"], cases["total"], ended,
                          std::to_string(percent) + " %", study["description"]});
  }
  return table;
}

}  // namespace

int print_studies(const StudyArguments& arguments) {
  const ordered_json studies = Client(arguments.server).get_all("/v1/studies", "studies");
  std::cout << (arguments.json ? ordered_json{{"studies", studies}}.dump(2) + "\n"
                               : as_text(table_of_studies(studies)));
  return kExitDone;
}

int show_studies(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, study_id);
  return print_answers(ids, arguments.json, [&](const std::string& id) {
    const ordered_json study = client.get(path_of_study(id));
    return Answer{study, study_text(study)};
  });
}

int print_results(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, study_id);
  if (arguments.json || arguments.format == "json") {
    write_results_json(client, ids, std::cout);
    return kExitDone;
  }
  if (arguments.format == "csv") {
    write_results_csv(client, ids, std::cout);
    return kExitDone;
  }
  return print_answers(ids, false, [&](const std::string& id) {
    return Answer{nullptr, (ids.size() > 1 ? id + "\n" : "") + results_text(client, id)};
  });
}

int print_phase_diagrams(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, study_id);
  return print_answers(ids, arguments.json, [&](const std::string& id) {
    const ordered_json diagram = client.get(path_of_study(id, "/phase-diagram"), section_query(arguments));
    const std::string title = ids.size() > 1 ? id + "\n" : "";
    return Answer{diagram,
                  title + phase_diagram_text(phase_diagram_from_json(diagram), colours_are_wanted())};
  });
}

int print_boundaries(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, study_id);
  const bool as_json = arguments.json || arguments.format == "json";
  return print_answers(ids, as_json, [&](const std::string& id) {
    const ordered_json boundary = client.get(path_of_study(id, "/boundary"));
    if (as_json) return Answer{boundary, ""};
    if (arguments.format == "csv") return Answer{nullptr, as_csv(boundary_table(boundary))};
    return Answer{nullptr, (ids.size() > 1 ? id + "\n" : "") + boundary_text(boundary)};
  });
}

int explain(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> paths = resolve_all(client, arguments.ids, path_of_any);
  return print_answers(paths, arguments.json, [&](const std::string& path) {
    const ordered_json found = client.get(path + "/why");
    std::string text = found["id"].get<std::string>() + ": " + found["state"].get<std::string>() + "\n";
    for (const ordered_json& reason : found["reasons"]) text += "  " + reason_text(reason) + "\n";
    return Answer{found, text};
  });
}

}  // namespace capstan
