#include "runner/web/routes.hpp"

#include <iostream>
#include <optional>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

constexpr Route kRoutes[] = {
    {"GET", "/healthz", get_health},
    {"GET", "/readyz", get_readiness},
    {"GET", "/metrics", get_metrics},
    {"GET", "/openapi.yaml", get_openapi},
    {"GET", "/study.schema.json", get_study_schema},
    {"GET", "/case.schema.json", get_case_schema},
    {"POST", "/v1/studies", post_study},
    {"GET", "/v1/studies", get_studies},
    {"GET", "/v1/studies/{id}", get_study},
    {"GET", "/v1/studies/{id}/cases", get_study_cases},
    {"GET", "/v1/studies/{id}/phase-diagram", get_phase_diagram},
    {"GET", "/v1/studies/{id}/events", get_study_events},
    {"POST", "/v1/studies/{id}/cancel", cancel_study},
    {"POST", "/v1/studies/{id}/pause", pause_study},
    {"POST", "/v1/studies/{id}/resume", resume_study},
    {"POST", "/v1/studies/{id}/retry", retry_study},
    {"POST", "/v1/studies/{id}/priority", set_priority},
    {"GET", "/v1/cases/{id}", get_case},
    {"GET", "/v1/cases/{id}/why", get_case_why},
    {"GET", "/v1/cases/{id}/history", get_case_history},
};

/// The path's id ("" on a route without one), if the path matches the route's.
std::optional<std::string> match(std::string_view pattern, std::string_view path) {
  constexpr std::string_view kId = "{id}";
  const std::size_t at = pattern.find(kId);
  if (at == std::string_view::npos) return path == pattern ? std::optional<std::string>("") : std::nullopt;
  const std::string_view after = pattern.substr(at + kId.size());
  if (!path.starts_with(pattern.substr(0, at)) || !path.ends_with(after)) return std::nullopt;
  if (path.size() <= at + after.size()) return std::nullopt;
  const std::string_view id = path.substr(at, path.size() - at - after.size());
  return id.find('/') == std::string_view::npos ? std::optional<std::string>(id) : std::nullopt;
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

}  // namespace

std::span<const Route> routes() { return kRoutes; }

Response respond(Service& service, const Request& request) try {
  std::string allowed;
  for (const Route& route : kRoutes) {
    const auto id = match(route.path, request.path);
    if (!id) continue;
    if (route.method == request.method) return tagged(route.handler(service, request, *id), request);
    allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
  }
  return allowed.empty() ? problem(404, "Not found", "there is nothing at " + request.path)
                         : not_allowed(allowed);
} catch (const KeyReused& reuse) {
  return problem(422, "Idempotency key reused", reuse.what());
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
