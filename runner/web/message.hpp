#pragma once
// HTTP without a network: what a request asks and what a response says.
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/case/parse.hpp"

namespace capstan {

using Query = std::vector<std::pair<std::string, std::string>>;

struct Request {
  std::string method;
  std::string path;    ///< as it came, its %-escapes not decoded
  Query query;         ///< decoded, in the order in which it came
  std::string accept;  ///< the header of that name
  std::string body;
  std::string idempotency_key = {};  ///< the header of that name
  std::string if_none_match = {};    ///< the header of that name
  std::string last_event_id = {};    ///< the header of that name
};

struct Response {
  int status = 200;
  std::string content_type;
  std::string body;
  std::map<std::string, std::string> headers;
  /// Of a body that comes in parts, instead of `body`: waits for a moment at most and gives what is new,
  /// maybe nothing; no text at all is the end.
  std::function<std::optional<std::string>()> next = {};
};

Response json_response(int status, const nlohmann::ordered_json& body);
Response csv_response(std::string body);

/// application/problem+json (RFC 9457), with one entry of `errors` an issue.
Response problem(int status, const std::string& title, const std::string& detail, const Issues& issues = {});

/// The value of a query parameter, or "".
std::string query_value(const Request& request, const std::string& key);

}  // namespace capstan
