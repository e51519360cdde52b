#include "runner/web/routes.hpp"

#include <iostream>
#include <optional>
#include <vector>

#include "runner/web/entity_tag.hpp"
#include "runner/web/request_checks.hpp"
#include "runner/web/request_target.hpp"

namespace capstan {
namespace {

constexpr std::string_view kRetryKeys[] = {"fidelity"};
constexpr std::string_view kPriorityKeys[] = {"priority"};

constexpr Route kRoutes[] = {
    {"GET", "/", get_page_file},
    {"GET", "/page/{id}", get_page_file},
    {"GET", "/healthz", get_health},
    {"GET", "/readyz", get_readiness},
    {"GET", "/metrics", get_metrics},
    {"GET", "/openapi.yaml", get_openapi},
    {"GET", "/study.schema.json", get_study_schema},
    {"GET", "/case.schema.json", get_case_schema},
    {"POST", "/v1/plan", post_plan, nullptr, {}, true},
    {"POST", "/v1/studies", post_study, nullptr, {}, true},
    {"GET", "/v1/studies", get_studies, page_parameters},
    {"GET", "/v1/studies/{id}", get_study},
    {"DELETE", "/v1/studies/{id}", delete_study},
    {"GET", "/v1/studies/{id}/cases", get_study_cases, case_list_parameters},
    {"GET", "/v1/studies/{id}/histories", get_study_histories, histories_parameters},
    {"GET", "/v1/studies/{id}/why", get_study_why},
    {"GET", "/v1/studies/{id}/phase-diagram", get_phase_diagram, phase_diagram_parameters},
    {"GET", "/v1/studies/{id}/boundary", get_boundary, format_parameters},
    {"GET", "/v1/studies/{id}/events", get_study_events},
    {"POST", "/v1/studies/{id}/cancel", cancel_study},
    {"POST", "/v1/studies/{id}/pause", pause_study},
    {"POST", "/v1/studies/{id}/resume", resume_study},
    {"POST", "/v1/studies/{id}/retry", retry_study, nullptr, kRetryKeys},
    {"POST", "/v1/studies/{id}/priority", set_priority, nullptr, kPriorityKeys},
    {"GET", "/v1/cases/{id}", get_case},
    {"GET", "/v1/cases/{id}/why", get_case_why},
    {"GET", "/v1/cases/{id}/shapes", get_case_shapes, shapes_parameters},
    {"GET", "/v1/cases/{id}/history", get_case_history, format_parameters},
    {"GET", "/v1/ids/{id}", get_ids},
};

/// The segment that stands for "{id}", or "" if the pattern has none; nothing if the path does not match.
/// \param segments  of the path, decoded
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

/// 400 for a query, 422 for a body that the route does not accept.
std::optional<Response> refuse_unknown(const Route& route, const httplib::Request& request) {
  const Issues query =
      check_query(route.query ? route.query() : std::span<const QueryParameter>(), request.params);
  if (!query.empty()) return problem(400, "Invalid query", "the query makes no sense here", query);
  const Issues body = route.checks_body ? Issues() : check_body(route.body_keys, request.body);
  if (!body.empty()) return problem(422, "Invalid body", "nothing was changed", body);
  return std::nullopt;
}

Response not_allowed(const std::string& allowed) {
  Response response = problem(405, "Method not allowed", "this path answers to: " + allowed);
  response.headers["Allow"] = allowed;
  return response;
}

/// HEAD is answered as GET; the connection omits the body.
Response dispatch(Service& service, const httplib::Request& request) {
  const std::string method = request.method == "HEAD" ? "GET" : request.method;
  const std::vector<std::string> segments = path_segments(request.path);
  std::string allowed;
  for (const Route& route : kRoutes) {
    const auto id = match(route.path, segments);
    if (!id) continue;
    if (route.method == method) {
      if (auto refusal = refuse_unknown(route, request)) return *refusal;
      return with_entity_tag(route.handler(service, request, *id), request);
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
  }
  return allowed.empty() ? problem(404, "Not found", "there is nothing at " + request.path)
                         : not_allowed(allowed);
}

void log_error(const httplib::Request& request, const std::string& what) {
  std::clog << "capstan: " << request.method << ' ' << request.path << ": " << what << std::endl;
}

/// SQLite has no checksums: damage is noticed only when a damaged page is read.
Response report_damage(Service& service, const httplib::Request& request, const std::string& what) {
  log_error(request, what);
  service.report_damage(what);
  return problem(503, "Not available", what);
}

}  // namespace

std::span<const Route> routes() { return kRoutes; }

Response respond(Service& service, const httplib::Request& request) try {
  return dispatch(service, request);
} catch (const KeyReused& reuse) {
  return problem(422, "Idempotency key reused", reuse.what());
} catch (const DatabaseDamaged& error) {
  return report_damage(service, request, error.what());
} catch (
    const nlohmann::json::parse_error& error) {  // of a stored document: bodies are parsed without exceptions
  return report_damage(
      service, request,
      std::string("a stored document cannot be read (") + error.what() + ")" + kWhatToDoAboutDamage);
} catch (const DatabaseUnavailable& error) {
  log_error(request, error.what());
  Response refusal = problem(503, "Not available", error.what());
  refusal.headers["Retry-After"] = "5";
  return refusal;
} catch (const std::exception& error) {
  log_error(request, error.what());
  return problem(500, "Internal error", error.what());
}

}  // namespace capstan
