#pragma once
// What a route answers. The library's httplib::Response is not used: it has no documented way to take the
// parts of a streamed body out of it again, and this server writes its responses itself.
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "solver/case/parse.hpp"

namespace capstan {

struct Response {
  int status = 200;
  std::string content_type;
  std::string body;
  std::map<std::string, std::string> headers;
  /// For a streamed response, used instead of `body`: returns the next part of the body, which may be empty,
  /// or nothing at the end of the stream. Blocks for a fraction of a second at most.
  std::function<std::optional<std::string>()> next = {};
};

Response json_response(int status, const nlohmann::ordered_json& body);
Response csv_response(std::string body);

/// An error as application/problem+json (RFC 9457). `errors` lists the issues, if there are any.
Response problem(int status, const std::string& title, const std::string& detail, const Issues& issues = {});

/// The status line and the header lines, up to and with the empty line (RFC 9112). Every response closes its
/// connection.
std::string response_head(const Response& response);

}  // namespace capstan
