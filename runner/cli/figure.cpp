// Pictures of studies and cases.
#include <algorithm>
#include <iostream>
#include <iterator>

#include "runner/cli/answers.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/differing_parameters.hpp"
#include "runner/cli/pictured_cases.hpp"
#include "runner/cli/pictured_shapes.hpp"
#include "runner/cli/published_series.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/render/history_picture.hpp"
#include "runner/render/phase_diagram_picture.hpp"
#include "runner/render/result_tables.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Whether the study has two axes with more than one value.
bool has_two_axes(const ordered_json& study) {
  return std::ranges::count_if(study["axes"], [](const auto& axis) { return axis["values"].size() > 1; }) >=
         2;
}

std::string kind_of(Client& client, const FigureArguments& arguments, const std::vector<std::string>& paths) {
  if (!arguments.kind.empty()) return arguments.kind;
  if (paths.size() != 1 || !is_study(paths[0])) return "history";
  const ordered_json study = client.get(paths[0]);
  return has_two_axes(study) || !study["boundary"].is_null() ? "phase-diagram" : "history";
}

std::multimap<std::string, std::string> section_query(const FigureArguments& arguments) {
  std::multimap<std::string, std::string> query;
  if (!arguments.x.empty()) query.emplace("x", arguments.x);
  if (!arguments.y.empty()) query.emplace("y", arguments.y);
  for (const std::string& fixed : arguments.at) query.emplace("at", fixed);
  return query;
}

History history_of(Client& client, const std::string& case_path) {
  const ordered_json columns = client.get(case_path + "/history");
  History history(columns["kt"].size());
  for (std::size_t row = 0; row < kObservableCount; ++row) {
    const auto column = columns.find(std::string(kObservables[row].name));
    if (column == columns.end()) continue;
    for (std::size_t i = 0; i < history.size(); ++i)
      if ((*column)[i].is_number()) history[i].values[row] = (*column)[i];
  }
  return history;
}

std::vector<Curve> curves_of(Client& client, const std::vector<PicturedCase>& cases) {
  std::vector<Curve> curves;
  for (const PicturedCase& c : cases) curves.push_back({c.title, history_of(client, c.path)});
  return curves;
}

std::vector<PublishedSeries> published_of(const FigureArguments& arguments,
                                          const std::vector<PicturedCase>& cases) {
  std::vector<PublishedSeries> all;
  for (const std::string& file : arguments.published)
    std::ranges::move(published_series(file, cases), std::back_inserter(all));
  return all;
}

std::vector<PublishedBoundary> published_boundaries_of(const FigureArguments& arguments,
                                                       const PhaseDiagram& diagram) {
  std::vector<PublishedBoundary> all;
  for (const std::string& file : arguments.published)
    std::ranges::move(published_boundaries(file, diagram.x.parameter, diagram.y.parameter),
                      std::back_inserter(all));
  return all;
}

std::string script_of(Client& client, const FigureArguments& arguments, const PictureFormat& format) {
  const std::vector<std::string> paths = resolve_all(client, arguments.ids, path_of_any);
  const std::string kind = kind_of(client, arguments, paths);
  if (kind != "phase-diagram") {
    const std::vector<PicturedCase> cases = pictured_cases(client, paths, arguments.at);
    if (kind == "path") return path_script(curves_of(client, cases), format);
    if (kind == "profile") return profile_script(profile_panels(client, cases, arguments.times), format);
    if (kind == "trajectory") return trajectory_script(trajectories(client, cases), format);
    return history_script(curves_of(client, cases), published_of(arguments, cases), format);
  }
  if (paths.size() != 1 || !is_study(paths[0]))
    throw std::invalid_argument("a phase diagram is of one study; for cases take --of history or --of path");
  const bool has_boundary = !client.get(paths[0])["boundary"].is_null();
  const PhaseDiagram diagram =
      phase_diagram_from_json(client.get(paths[0] + "/phase-diagram", section_query(arguments)));
  return phase_diagram_script(diagram, has_boundary ? client.get(paths[0] + "/boundary") : ordered_json(),
                              published_boundaries_of(arguments, diagram), format);
}

/// The histories of several cases as one table. The parameters in which the cases differ stand first.
std::string histories_as_csv(Client& client, const std::vector<std::string>& paths) {
  std::vector<ordered_json> cases;
  for (const std::string& path : paths) cases.push_back(client.get(path));
  std::vector<ordered_json> parameters;
  for (const ordered_json& shown : cases) parameters.push_back(shown["parameters"]);
  const std::vector<std::string> differing = differing_parameters(parameters);
  Table all{{"case"}, {}};
  for (const std::string& path : differing) all.columns.push_back(name_of_parameter(path));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Table table = history_table(client.get(paths[i] + "/history"));
    if (i == 0) std::ranges::copy(table.columns, std::back_inserter(all.columns));
    for (const auto& record : table.rows) {
      auto& row = all.rows.emplace_back();
      row.push_back(cases[i]["id"]);
      for (const std::string& path : differing) row.push_back(parameter_at(parameters[i], path));
      std::ranges::copy(record, std::back_inserter(row));
    }
  }
  return as_csv(all);
}

}  // namespace

int draw_figure(const FigureArguments& arguments) {
  const PictureFormat format{arguments.out,
                             arguments.is_wide ? PictureWidth::two_columns : PictureWidth::one_column};
  if (const std::string issue = issue_of_picture_file(format.file); !issue.empty())
    throw std::invalid_argument(issue);
  Client client(arguments.server);
  draw(script_of(client, arguments, format), format);
  return kExitDone;
}

int print_histories(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> paths = resolve_all(client, arguments.ids, path_of_any);
  if (std::ranges::any_of(paths, is_study))
    throw std::invalid_argument(
        "a history is of a case; capstan results lists those of a study, and "
        "GET /v1/studies/{id}/histories has all of them on one time grid");
  if (paths.size() > 1 && !arguments.json) {
    std::cout << histories_as_csv(client, paths);
    return kExitDone;
  }
  return print_answers(paths, arguments.json, [&](const std::string& path) {
    const ordered_json columns = client.get(path + "/history");
    return Answer{columns, arguments.json ? "" : as_csv(history_table(columns))};
  });
}

}  // namespace capstan
