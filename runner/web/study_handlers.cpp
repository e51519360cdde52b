#include <filesystem>
#include <functional>

#include "runner/queries/boundary.hpp"
#include "runner/queries/disk_warning.hpp"
#include "runner/queries/phase_diagram.hpp"
#include "runner/queries/queries.hpp"
#include "runner/queries/why.hpp"
#include "runner/render/boundary_table.hpp"
#include "runner/render/result_columns.hpp"
#include "runner/render/result_tables.hpp"
#include "runner/study/study_plan.hpp"
#include "runner/web/accept_header.hpp"
#include "runner/web/handlers.hpp"
#include "runner/web/page_query.hpp"
#include "solver/case/run_size.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

Response no_such_study(const std::string& id) {
  return problem(404, "Not found", "there is no study \"" + id + "\"");
}

/// A study whose runs need more disk than is free is accepted with a warning: space may be freed before they
/// run.
ordered_json warnings_of(const Study& study, const Service& service) {
  double bytes = 0;
  for (const Case& c : study.cases) bytes += run_size(c);
  std::error_code error;
  const auto space = std::filesystem::space(service.data().runs(), error);
  if (error) return ordered_json::array({service.why_nothing_starts()});
  const std::string warning =
      disk_warning(bytes, static_cast<double>(space.available), service.data().runs().string());
  return warning.empty() ? ordered_json::array() : ordered_json::array({warning});
}

ordered_json with_links(ordered_json study) {
  const std::string self = "/v1/studies/" + study["id"].get<std::string>();
  study["links"] = {{"self", self},
                    {"cases", self + "/cases"},
                    {"histories", self + "/histories"},
                    {"phase_diagram", self + "/phase-diagram"}};
  if (!study["boundary"].is_null()) study["links"]["boundary"] = self + "/boundary";
  return study;
}

/// The study after a change.
/// \param cases  how many of its cases the change concerned; nothing if there is no such study
Response changed_study(Service& service, const std::string& id, std::optional<int> cases) {
  if (!cases) return no_such_study(id);
  const Readers::Reader database = service.reader();
  ordered_json study = with_links(*find_study(*database, id));
  study["changed"] = *cases;
  return json_response(200, study);
}

/// How many cases a retry at another fidelity replaces; nothing if there is no such study.
std::optional<int> replaceable_cases(Service& service, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto study = find_study(*database, id);
  if (!study) return std::nullopt;
  const ordered_json& cases = (*study)["cases"];
  return (*study)["cancelled"] ? 0 : cases["failed"].get<int>() + cases["diverged"].get<int>();
}

/// Calls `use` with all points that the filter selects, part by part.
void for_each_part(Database& database, const std::string& id, const CaseFilter& filter,
                   const std::function<void(const ordered_json& points)>& use) {
  PageRequest wanted;
  for (bool is_last = false; !is_last;) {
    const Page part = find_cases(database, id, filter, wanted);
    use(part.items);
    wanted.after = part.next;
    is_last = !part.next;
  }
}

/// All points that the filter selects; CSV has no pages.
Response cases_as_csv(Database& database, const std::string& id, const CaseFilter& filter) {
  ResultColumns seen;
  for_each_part(database, id, filter, [&](const ordered_json& points) { seen.look_at(points); });
  const auto columns = seen.all();
  std::string text = as_csv(table_of(ordered_json::array(), columns));
  for_each_part(database, id, filter,
                [&](const ordered_json& points) { text += csv_rows(table_of(points, columns)); });
  return csv_response(std::move(text));
}

Response varies_by_accept(Response response) {
  response.headers["Vary"] = "Accept";
  return response;
}

}  // namespace

/// The plan of a study or a case. Nothing is stored.
Response post_plan(Service&, const httplib::Request& request, const std::string&) {
  const InputDocument document = parse_document(request.body);
  if (!document.study && !document.single_case)
    return problem(422, "Invalid study", "the study or case is not valid, there is no plan", document.issues);
  return json_response(200, plan_json(document));
}

/// 201 for a new study, 200 for a known one, 422 for one with issues, which is not stored. `resumed`: the
/// study was paused until now.
Response post_study(Service& service, const httplib::Request& request, const std::string&) {
  constexpr std::size_t kMaxKey = 200;
  const std::string key = request.get_header_value("Idempotency-Key");
  if (key.size() > kMaxKey)
    return problem(400, "Invalid key", "an Idempotency-Key has at most 200 characters");
  const ParsedStudy parsed = parse_study_text(request.body);
  if (!parsed.value) {
    return problem(422, "Invalid study", "the study is not valid, nothing was queued", parsed.issues);
  }
  const Submission submission = service.submit(*parsed.value, key);
  const Readers::Reader database = service.reader();
  ordered_json study = with_links(*find_study(*database, submission.study_id));
  study["warnings"] = submission.is_new ? warnings_of(*parsed.value, service) : ordered_json::array();
  study["resumed"] = submission.is_resumed;
  Response response = json_response(submission.is_new ? 201 : 200, study);
  response.headers["Location"] = study["links"]["self"];
  return response;
}

Response get_studies(Service& service, const httplib::Request& request, const std::string&) {
  const PageQuery page = read_page_query(request);
  if (!page.issues.empty()) return problem(400, "Invalid page", "the query names no page", page.issues);
  const Readers::Reader database = service.reader();
  const Page found = list_studies(*database, page.wanted);
  ordered_json studies = ordered_json::array();
  for (const ordered_json& study : found.items) studies.push_back(with_links(study));
  return json_response(200, with_next({{"studies", studies}}, found, page));
}

Response get_study(Service& service, const httplib::Request&, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto study = find_study(*database, id);
  return study ? json_response(200, with_links(*study)) : no_such_study(id);
}

Response get_study_why(Service& service, const httplib::Request&, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto reasons = why_study(*database, id, service.places());
  return reasons ? json_response(200, *reasons) : no_such_study(id);
}

Response get_study_cases(Service& service, const httplib::Request& request, const std::string& id) {
  const PageQuery page = read_page_query(request);
  if (!page.issues.empty()) return problem(400, "Invalid page", "the query names no page", page.issues);
  const Readers::Reader database = service.reader();
  if (!find_study(*database, id)) return no_such_study(id);
  if (wants_csv(request)) return varies_by_accept(cases_as_csv(*database, id, page.rest));
  Page found = find_cases(*database, id, page.rest, page.wanted);
  add_places(*database, service.places(), found.items);
  return varies_by_accept(
      json_response(200, with_next({{"study", id}, {"cases", found.items}}, found, page)));
}

Response get_phase_diagram(Service& service, const httplib::Request& request, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto study = find_study(*database, id);
  if (!study) return no_such_study(id);
  if ((*study)["axes"].empty())
    return problem(404, "Not found", "the study has no axis to draw a phase diagram over");
  DiagramRequest wanted{request.get_param_value("x"), request.get_param_value("y"), {}};
  const auto [first, last] = request.params.equal_range("at");
  for (auto at = first; at != last; ++at) wanted.at.push_back(at->second);
  const ParsedDiagram diagram = phase_diagram(*study, find_points(*database, id), wanted);
  if (!diagram.value)
    return problem(400, "Invalid diagram", "the query names no diagram of this study", diagram.issues);
  return varies_by_accept(wants_csv(request) ? csv_response(as_csv(diagram_table(*diagram.value)))
                                             : json_response(200, to_json(*diagram.value)));
}

Response get_boundary(Service& service, const httplib::Request& request, const std::string& id) {
  const Readers::Reader database = service.reader();
  if (!find_study(*database, id)) return no_such_study(id);
  const auto boundary = find_boundary(*database, id);
  if (!boundary)
    return problem(404, "Not found",
                   "the study seeks no boundary; for that a study has \"boundary\": {\"along\": \"Ca\", "
                   "\"between\": [0.05, 1], \"for\": {\"V\": [1, 2, 4]}} instead of axes. capstan "
                   "phase-diagram and capstan results show the motions of this one");
  return varies_by_accept(wants_csv(request) ? csv_response(as_csv(boundary_table(*boundary)))
                                             : json_response(200, *boundary));
}

Response delete_study(Service& service, const httplib::Request&, const std::string& id) {
  const auto deletion = service.remove(id);
  if (!deletion) return no_such_study(id);
  return json_response(200,
                       {{"study", id}, {"deleted_cases", deletion->deleted}, {"kept_cases", deletion->kept}});
}

Response cancel_study(Service& service, const httplib::Request&, const std::string& id) {
  return changed_study(service, id, service.cancel(id));
}

Response pause_study(Service& service, const httplib::Request&, const std::string& id) {
  return changed_study(service, id, service.pause(id, true));
}

Response resume_study(Service& service, const httplib::Request&, const std::string& id) {
  return changed_study(service, id, service.pause(id, false));
}

/// Without a body, queues the failed cases again. With {"fidelity": …}, replaces the failed and the diverged
/// cases by cases of that fidelity.
Response retry_study(Service& service, const httplib::Request& request, const std::string& id) {
  if (!request.body.empty()) {
    const ParsedJson parsed = parse_json(request.body);
    const bool is_object = parsed.value && parsed.value->is_object() && parsed.value->contains("fidelity");
    const std::optional<int> replaceable = replaceable_cases(service, id);
    Issues issues = is_object ? service.retry_at(id, (*parsed.value)["fidelity"])
                              : Issues{{"", "send nothing, or {\"fidelity\": …} as in a study's base"}};
    if (!issues.empty()) return problem(422, "Invalid retry", "nothing was changed", issues);
    return changed_study(service, id, replaceable);
  }
  return changed_study(service, id, service.retry(id));
}

Response set_priority(Service& service, const httplib::Request& request, const std::string& id) {
  constexpr int kMax = 100;
  const ParsedJson parsed = parse_json(request.body);
  const bool is_object = parsed.value && parsed.value->is_object() && parsed.value->contains("priority");
  const nlohmann::json given = is_object ? (*parsed.value)["priority"] : nlohmann::json();
  if (!given.is_number_integer() || given < -kMax || given > kMax)
    return problem(422, "Invalid priority", "send {\"priority\": N}",
                   {{"/priority", "must be a whole number from -100 to 100"}});
  return changed_study(service, id, service.set_priority(id, given));
}

}  // namespace capstan
