#include "runner/web/response.hpp"

#include <string_view>

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Logs of runs may contain bytes that are not UTF-8; JSON cannot, so they are replaced.
std::string text_of(const ordered_json& body) {
  return body.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// Of the statuses that this server sends (RFC 9110, 15; RFC 6585).
std::string_view reason_phrase(int status) {
  switch (status) {
    // clang-format off
    case 200: return "OK";
    case 201: return "Created";
    case 204: return "No Content";
    case 304: return "Not Modified";
    case 400: return "Bad Request";
    case 401: return "Unauthorized";
    case 403: return "Forbidden";
    case 404: return "Not Found";
    case 405: return "Method Not Allowed";
    case 408: return "Request Timeout";
    case 411: return "Length Required";
    case 413: return "Content Too Large";
    case 414: return "URI Too Long";
    case 415: return "Unsupported Media Type";
    case 416: return "Range Not Satisfiable";
    case 417: return "Expectation Failed";
    case 421: return "Misdirected Request";
    case 422: return "Unprocessable Content";
    case 431: return "Request Header Fields Too Large";
    case 500: return "Internal Server Error";
    case 501: return "Not Implemented";
    case 503: return "Service Unavailable";
    case 505: return "HTTP Version Not Supported";
      // clang-format on
  }
  return "";
}

/// RFC 9110, 8.6: 204 has no Content-Length, and 304 may only have that of the 200 it stands for. A stream
/// ends with its connection.
bool has_length(const Response& response) {
  return response.status != 204 && response.status != 304 && !response.next;
}

}  // namespace

Response json_response(int status, const ordered_json& body) {
  return {status, "application/json", text_of(body), {}};
}

Response csv_response(std::string body) { return {200, "text/csv; charset=utf-8", std::move(body), {}}; }

Response problem(int status, const std::string& title, const std::string& detail, const Issues& issues) {
  ordered_json body = {{"type", "about:blank"}, {"title", title}, {"status", status}, {"detail", detail}};
  for (const Issue& issue : issues)
    body["errors"].push_back({{"pointer", issue.pointer}, {"detail", issue.message}});
  return {status, "application/problem+json", text_of(body), {}};
}

std::string response_head(const Response& response) {
  std::string head = "HTTP/1.1 " + std::to_string(response.status) + " ";
  head.append(reason_phrase(response.status)).append("\r\n");
  const auto add = [&](const std::string& name, const std::string& value) {
    head.append(name).append(": ").append(value).append("\r\n");
  };
  add("Content-Type", response.content_type);
  if (has_length(response)) add("Content-Length", std::to_string(response.body.size()));
  add("Connection", "close");
  add("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : response.headers) add(name, value);
  return head.append("\r\n");
}

}  // namespace capstan
