#include "runner/web/message.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// What a process wrote to its log may be no UTF-8; such bytes are replaced.
std::string text_of(const ordered_json& body) {
  return body.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
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

std::string query_value(const Request& request, const std::string& key) {
  for (const auto& [name, value] : request.query)
    if (name == key) return value;
  return "";
}

}  // namespace capstan
