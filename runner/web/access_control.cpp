#include "runner/web/access_control.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <string_view>

#include "runner/web/ascii_case.hpp"
#include "runner/web/bearer_token.hpp"
#include "runner/web/page_files.hpp"

namespace capstan {
namespace {

/// "example.org:80" → "example.org", "[::1]:80" → "[::1]"
std::string without_port(const std::string& authority) {
  const auto end = authority.starts_with('[') ? authority.find(']') : authority.rfind(':');
  if (end == authority.npos) return authority;
  return authority.substr(0, authority[end] == ']' ? end + 1 : end);
}

/// Numeric hosts are safe: DNS rebinding needs a host name.
bool is_numeric_address(const std::string& host) {
  unsigned char bytes[16];
  if (host.starts_with('[') && host.ends_with(']'))
    return inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), bytes) == 1;
  return inet_pton(AF_INET, host.c_str(), bytes) == 1;
}

bool is_listed(const AccessControl& access, const std::string& host) {
  return std::any_of(access.hosts.begin(), access.hosts.end(),
                     [&](const std::string& name) { return equal_ignoring_case(name, host); });
}

bool is_own_host(const AccessControl& access, const std::string& authority) {
  const std::string host = without_port(authority);
  return equal_ignoring_case(host, "localhost") || is_numeric_address(host) || is_listed(access, host);
}

/// True if the page comes from this server: from the host that the request names, or from one of the listed
/// names (behind a proxy). The origin "null" belongs to no server.
bool is_own_origin(const AccessControl& access, const std::string& origin, const std::string& host) {
  const auto end = origin.find("://");
  if (end == origin.npos) return false;
  const std::string authority = origin.substr(end + 3);
  return equal_ignoring_case(authority, host) || is_listed(access, without_port(authority));
}

bool has_token(const httplib::Request& request, const std::string& token) {
  constexpr std::string_view kScheme = "Bearer ";
  const std::string field = request.get_header_value("Authorization");
  return equal_ignoring_case(field.substr(0, kScheme.size()), kScheme) &&
         equal_in_constant_time(std::string_view(field).substr(kScheme.size()), token);
}

/// The page says nothing about studies; a browser can only send the token once the page has asked for it.
bool asks_for_page(const httplib::Request& request) {
  return (request.method == "GET" || request.method == "HEAD") && find_page_file(request.path);
}

}  // namespace

std::optional<Response> refuse_access(const AccessControl& access, const httplib::Request& request) {
  const std::string host = request.get_header_value("Host");
  if (!is_own_host(access, host))
    return problem(421, "Misdirected request",
                   "this server is not known as " + host + "; name it with: capstan serve --host");
  if (request.has_header("Origin") && !is_own_origin(access, request.get_header_value("Origin"), host))
    return problem(403, "Forbidden", "pages of other sites may not ask");
  if (!access.token || asks_for_page(request) || has_token(request, *access.token)) return std::nullopt;
  Response refusal = problem(401, "Unauthorized", "send the token: Authorization: Bearer TOKEN");
  refusal.headers["WWW-Authenticate"] = "Bearer";
  return refusal;
}

}  // namespace capstan
