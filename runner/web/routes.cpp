#include "runner/web/routes.hpp"

#include <iostream>
#include <optional>
#include <vector>

#include "runner/web/target.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

constexpr std::string_view kRetryKeys[] = {"fidelity"};
constexpr std::string_view kPriorityKeys[] = {"priority"};

constexpr Route kRoutes[] = {
    {"GET", "/healthz", get_health},
    {"GET", "/readyz", get_readiness},
    {"GET", "/metrics", get_metrics},
    {"GET", "/openapi.yaml", get_openapi},
    {"GET", "/study.schema.json", get_study_schema},
    {"GET", "/case.schema.json", get_case_schema},
    {"POST", "/v1/studies", post_study, nullptr, {}, true},
    {"GET", "/v1/studies", get_studies, page_parameters},
    {"GET", "/v1/studies/{id}", get_study},
    {"DELETE", "/v1/studies/{id}", delete_study},
    {"GET", "/v1/studies/{id}/cases", get_study_cases, case_list_parameters},
    {"GET", "/v1/studies/{id}/why", get_study_why},
    {"GET", "/v1/studies/{id}/phase-diagram", get_phase_diagram, phase_diagram_parameters},
    {"GET", "/v1/studies/{id}/events", get_study_events},
    {"POST", "/v1/studies/{id}/cancel", cancel_study},
    {"POST", "/v1/studies/{id}/pause", pause_study},
    {"POST", "/v1/studies/{id}/resume", resume_study},
    {"POST", "/v1/studies/{id}/retry", retry_study, nullptr, kRetryKeys},
    {"POST", "/v1/studies/{id}/priority", set_priority, nullptr, kPriorityKeys},
    {"GET", "/v1/cases/{id}", get_case},
    {"GET", "/v1/cases/{id}/why", get_case_why},
    {"GET", "/v1/cases/{id}/history", get_case_history, history_parameters},
    {"GET", "/v1/ids/{id}", get_ids},
};

/// The path's id ("" on a route without one), if the path matches the route's.
std::optional<std::string> match(std::string_view pattern, const std::vector<std::string>& segments) {
  const std::vector<std::string> parts = path_segments(pattern);
  if (parts.size() != segments.size()) return std::nullopt;
  std::string id;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_id = parts[i].starts_with('{') && !segments[i].empty();
    if (!is_id && parts[i] != segments[i]) return std::nullopt;
    if (is_id) id = segments[i];
  }
  return id;
}

/// A query and a body that the route does not know are refused, not ignored.
std::optional<Response> refuse_unknown(const Route& route, const Request& request) {
  const Issues query = check_query(route.query ? route.query() : std::span<const Parameter>(), request.query);
  if (!query.empty()) return problem(400, "Invalid query", "the query makes no sense here", query);
  const Issues body = route.reads_body ? Issues() : check_body(route.body_keys, request.body);
  if (!body.empty()) return problem(422, "Invalid body", "nothing was changed", body);
  return std::nullopt;
}

Response not_allowed(const std::string& allowed) {
  Response response = problem(405, "Method not allowed", "this path answers to: " + allowed);
  response.headers["Allow"] = allowed;
  return response;
}

/// One of a list such as `"a", W/"b"`, or any for `*`. A tag of ours is hexadecimal, so no other can hold it.
bool names(const std::string& list, const std::string& tag) {
  return list == "*" || list.find(tag) != list.npos;
}

/// A strong tag: equal tags, equal bytes. Who has those already is told so.
Response tagged(Response response, const Request& request) {
  if (request.method != "GET" || response.status != 200 || response.next) return response;
  const std::string tag = '"' + sha256_hex(response.body).substr(0, 32) + '"';
  if (names(request.if_none_match, tag)) response = {304, response.content_type, "", response.headers};
  response.headers["ETag"] = tag;
  return response;
}

/// SQLite has no checksums: damage may be seen only when a page is read.
Response damaged(Service& service, const Request& request, const std::string& what) {
  std::clog << "capstan: " << request.method << ' ' << request.path << ": " << what << std::endl;
  service.report_damage(what);
  return problem(503, "Not available", what);
}

}  // namespace

std::span<const Route> routes() { return kRoutes; }

Response respond(Service& service, const Request& request) try {
  std::string allowed;
  const std::vector<std::string> segments = path_segments(request.path);
  for (const Route& route : kRoutes) {
    const auto id = match(route.path, segments);
    if (!id) continue;
    if (route.method == request.method) {
      if (auto refusal = refuse_unknown(route, request)) return *refusal;
      return tagged(route.handler(service, request, *id), request);
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
  }
  return allowed.empty() ? problem(404, "Not found", "there is nothing at " + request.path)
                         : not_allowed(allowed);
} catch (const KeyReused& reuse) {
  return problem(422, "Idempotency key reused", reuse.what());
} catch (const DatabaseDamaged& error) {
  return damaged(service, request, error.what());
} catch (
    const nlohmann::json::parse_error& error) {  // of what is stored: what clients send is parsed without
  return damaged(
      service, request,
      std::string("a stored document cannot be read (") + error.what() + ")" + kWhatToDoAboutDamage);
} catch (const DatabaseUnavailable& error) {
  std::clog << "capstan: " << request.method << ' ' << request.path << ": " << error.what() << std::endl;
  Response refusal = problem(503, "Not available", error.what());
  refusal.headers["Retry-After"] = "5";
  return refusal;
} catch (const std::exception& error) {
  std::clog << "capstan: " << request.method << ' ' << request.path << ": " << error.what() << std::endl;
  return problem(500, "Internal error", error.what());
}

}  // namespace capstan
