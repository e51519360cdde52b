#pragma once
// HTTP without a network: what a request asks and what a response says.
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "solver/case/parse.hpp"

namespace capstan {

struct Request {
  std::string method;
  std::string path;
  std::vector<std::pair<std::string, std::string>> query;
  std::string accept;  ///< the header of that name
  std::string body;
  std::string idempotency_key = {};  ///< the header of that name
  std::string if_none_match = {};    ///< the header of that name
};

struct Response {
  int status = 200;
  std::string content_type;
  std::string body;
  std::map<std::string, std::string> headers;
};

Response json_response(int status, const nlohmann::ordered_json& body);
Response csv_response(std::string body);

/// application/problem+json (RFC 9457), with one entry of `errors` an issue.
Response problem(int status, const std::string& title, const std::string& detail, const Issues& issues = {});

/// The value of a query parameter, or "".
std::string query_value(const Request& request, const std::string& key);

}  // namespace capstan
