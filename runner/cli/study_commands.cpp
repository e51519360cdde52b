// The commands that ask the server for studies and cases.
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <iostream>

#include "runner/cli/axis_text.hpp"
#include "runner/cli/client.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/progress.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/cli/study_text.hpp"
#include "runner/cli/write_results.hpp"
#include "runner/queries/phase_diagram.hpp"
#include "runner/render/printable.hpp"
#include "runner/render/table.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// What a command found: a document for programs, text for people.
struct Answer {
  ordered_json document;
  std::string text;
};

bool has_several_lines(const std::string& text) { return text.find('\n') + 1 < text.size(); }

/// One id: its document. Several: a list of them. As text each is printed as it comes.
int print_answers(const std::vector<std::string>& targets, bool json,
                  const std::function<Answer(const std::string& target)>& ask) {
  ordered_json documents = ordered_json::array();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Answer answer = ask(targets[i]);
    if (json)
      documents.push_back(std::move(answer.document));
    else
      std::cout << (i > 0 && has_several_lines(answer.text) ? "\n" : "") << answer.text << std::flush;
  }
  if (json) std::cout << (targets.size() == 1 ? documents.front() : documents).dump(2) << '\n';
  return kExitDone;
}

/// All ids are known before anything is done with the first.
std::vector<std::string> resolved(Client& client, const StudyArguments& arguments,
                                  const std::function<std::string(Client&, const std::string&)>& resolve) {
  std::vector<std::string> targets;
  for (const std::string& typed : arguments.ids) targets.push_back(resolve(client, typed));
  return targets;
}

std::string path_of_study(const std::string& id, const std::string& rest = "") {
  return "/v1/studies/" + id + rest;
}

std::string study_text(const ordered_json& study) {
  std::string text =
      study["id"].get<std::string>() + "  " + printable(study["description"].get<std::string>()) + "\n";
  text += "submitted " + study["submitted_at"].get<std::string>() + ", " + study["state"].get<std::string>() +
          "\n";
  text += progress_text(study) + "\n";
  const auto points = study["points"].get<std::size_t>(), cases = study["cases"]["total"].get<std::size_t>();
  if (points != cases) text += size_text(points, cases) + "\n";
  for (const ordered_json& axis : study["axes"]) text += axis_text(axis["parameter"], axis["values"]) + "\n";
  for (const auto& [motion, count] : study["motions"].items())
    if (count > 0) text += motion + ": " + count.dump() + (points != cases ? " points\n" : "\n");
  return text + notes_text(study["notes"]);
}

std::multimap<std::string, std::string> diagram_query(const StudyArguments& arguments) {
  std::multimap<std::string, std::string> query;
  if (!arguments.x.empty()) query.emplace("x", arguments.x);
  if (!arguments.y.empty()) query.emplace("y", arguments.y);
  for (const std::string& fixed : arguments.at) query.emplace("at", fixed);
  return query;
}

/// https://no-color.org
bool colours_are_wanted() {
  const char* refusal = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) == 1 && (!refusal || *refusal == '\0');
}

std::string cases_text(std::int64_t count, const std::string& kind = "") {
  return std::to_string(count) + (kind.empty() ? "" : " " + kind) + (count == 1 ? " case" : " cases");
}

/// What a cancellation leaves: "", or a part of a sentence.
std::string left_text(std::int64_t cases) {
  if (cases == 0) return "";
  if (cases == 1) return ", 1 is still queued or running: it is about to stop, or another study wants it";
  return ", " + std::to_string(cases) +
         " are still queued or running: they are about to stop, or another study wants them";
}

/// What a change has done, in words.
std::string change_text(const ordered_json& study, const std::string& change) {
  const auto changed = study["changed"].get<std::int64_t>();
  const auto queued = study["cases"]["queued"].get<std::int64_t>();
  const auto running = study["cases"]["running"].get<std::int64_t>();
  const std::string id = study["id"].get<std::string>() + ": ";
  if (change == "cancel") return id + "cancelled " + cases_text(changed) + left_text(queued + running) + "\n";
  if (change == "pause")
    return id + "paused, " + cases_text(queued, "queued") + " will not start, " + std::to_string(running) +
           " running go on\n";
  if (change == "resume") return id + "resumed, " + cases_text(queued, "queued") + " can start\n";
  if (change == "retry") return id + "queued " + cases_text(changed) + " again\n";
  return id + "priority " + study["priority"].dump() + " for " + cases_text(queued, "queued") + "\n";
}

/// Of a case a sentence, of a study one with the number of cases it is about.
std::string reason_text(const ordered_json& reason) {
  if (reason.is_string()) return printable(reason.get<std::string>());
  return cases_text(reason["cases"].get<std::int64_t>()) + ": " +
         printable(reason["reason"].get<std::string>());
}

}  // namespace

int print_studies(const StudyArguments& arguments) {
  const ordered_json studies = Client(arguments.server).get_all("/v1/studies", "studies");
  if (arguments.json) {
    std::cout << ordered_json{{"studies", studies}}.dump(2) << '\n';
    return kExitDone;
  }
  Table table{{"study", "state", "submitted", "cases", "ended", "progress", "description"}, {}};
  for (const ordered_json& study : studies) {
    const ordered_json& cases = study["cases"];
    const int ended = cases["total"].get<int>() - cases["queued"].get<int>() - cases["running"].get<int>();
    const int percent = static_cast<int>(100 * study["progress"].get<double>());
    table.rows.push_back({study["id"], study["state"], study["submitted_at"], cases["total"], ended,
                          std::to_string(percent) + " %", study["description"]});
  }
  std::cout << as_text(table);
  return kExitDone;
}

int print_study(const StudyArguments& arguments) {
  Client client(arguments.server);
  return print_answers(resolved(client, arguments, study_id), arguments.json, [&](const std::string& id) {
    const ordered_json study = client.get(path_of_study(id));
    return Answer{study, study_text(study)};
  });
}

int print_results(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolved(client, arguments, study_id);
  const bool csv = arguments.format == "csv", json = arguments.json || arguments.format == "json";
  if (csv) write_results_csv(client, ids, std::cout);
  if (json) write_results_json(client, ids, std::cout);
  if (csv || json) return kExitDone;
  return print_answers(ids, false, [&](const std::string& id) {
    return Answer{nullptr, (ids.size() > 1 ? id + "\n" : "") + results_text(client, id)};
  });
}

int print_phase_diagram(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolved(client, arguments, study_id);
  return print_answers(ids, arguments.json, [&](const std::string& id) {
    const ordered_json answer = client.get(path_of_study(id, "/phase-diagram"), diagram_query(arguments));
    const std::string title = ids.size() > 1 ? id + "\n" : "";
    return Answer{answer, title + render(phase_diagram_from_json(answer), colours_are_wanted())};
  });
}

int change_study(const StudyArguments& arguments, const std::string& change, const std::string& body) {
  Client client(arguments.server);
  return print_answers(resolved(client, arguments, study_id), arguments.json, [&](const std::string& id) {
    const ordered_json study = client.post(path_of_study(id, "/" + change), body);
    return Answer{study, change_text(study, change)};
  });
}

int delete_study(const StudyArguments& arguments) {
  Client client(arguments.server);
  return print_answers(
      resolved(client, arguments, whole_study_id), arguments.json, [&](const std::string& id) {
        const ordered_json deletion = client.remove(path_of_study(id));
        const std::string text = id + ": deleted with " +
                                 cases_text(deletion["deleted_cases"].get<std::int64_t>()) + ", " +
                                 deletion["kept_cases"].dump() + " are kept for other studies\n";
        return Answer{deletion, text};
      });
}

int explain(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> paths = resolved(client, arguments, path_of_any);
  return print_answers(paths, arguments.json, [&](const std::string& path) {
    const ordered_json answer = client.get(path + "/why");
    std::string text = answer["id"].get<std::string>() + ": " + answer["state"].get<std::string>() + "\n";
    for (const ordered_json& reason : answer["reasons"]) text += "  " + reason_text(reason) + "\n";
    return Answer{answer, text};
  });
}

}  // namespace capstan
