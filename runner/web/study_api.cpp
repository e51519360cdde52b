#include "runner/results/phase_diagram.hpp"
#include "runner/results/queries.hpp"
#include "runner/study/study.hpp"
#include "runner/web/api.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

Response no_such_study(const std::string& id) {
  return problem(404, "Not found", "there is no study \"" + id + "\"");
}

ordered_json with_links(ordered_json study) {
  const std::string self = "/v1/studies/" + study["id"].get<std::string>();
  study["links"] = {{"self", self}, {"cases", self + "/cases"}, {"phase_diagram", self + "/phase-diagram"}};
  return study;
}

}  // namespace

/// 201 for a new study, 200 for one that is known; nothing is queued unless everything is valid.
Response post_study(Service& service, const Request& request, const std::string&) {
  const ParsedStudy parsed = parse_study_text(request.body);
  if (!parsed.value) {
    const std::string count = std::to_string(parsed.issues.size());
    return problem(422, "Invalid study",
                   count + (count == "1" ? " fault" : " faults") + ", nothing was queued", parsed.issues);
  }
  const Submission submission = service.submit(*parsed.value);
  Database database = service.reader();
  const ordered_json study = with_links(*find_study(database, submission.study_id));
  Response response = json_response(submission.is_new ? 201 : 200, study);
  response.headers["Location"] = study["links"]["self"];
  return response;
}

Response get_studies(Service& service, const Request&, const std::string&) {
  Database database = service.reader();
  ordered_json studies = ordered_json::array();
  for (ordered_json& study : list_studies(database)) studies.push_back(with_links(std::move(study)));
  return json_response(200, {{"studies", studies}});
}

Response get_study(Service& service, const Request&, const std::string& id) {
  Database database = service.reader();
  const auto study = find_study(database, id);
  return study ? json_response(200, with_links(*study)) : no_such_study(id);
}

Response get_study_cases(Service& service, const Request& request, const std::string& id) {
  const Issues issues = check_filter(request.query);
  if (!issues.empty()) return problem(400, "Invalid filter", "the query does not select cases", issues);
  Database database = service.reader();
  if (!find_study(database, id)) return no_such_study(id);
  return json_response(200, {{"study", id}, {"cases", find_cases(database, id, request.query)}});
}

Response get_phase_diagram(Service& service, const Request& request, const std::string& id) {
  Database database = service.reader();
  const auto study = find_study(database, id);
  if (!study) return no_such_study(id);
  const auto diagram = phase_diagram(*study, find_cases(database, id, {}), query_value(request, "x"),
                                     query_value(request, "y"));
  if (!diagram) return problem(404, "Not found", "the study has no such axes to draw a phase diagram over");
  return json_response(200, to_json(*diagram));
}

Response cancel_study(Service& service, const Request& request, const std::string& id) {
  return service.cancel(id) ? get_study(service, request, id) : no_such_study(id);
}

}  // namespace capstan
