#pragma once
// Which function answers which method and path.
#include <span>
#include <string>
#include <string_view>

#include "runner/web/api.hpp"
#include "runner/web/parameters.hpp"

namespace capstan {

struct Route {
  std::string_view method;
  std::string_view path;  ///< "{id}" stands for one segment
  Handler handler;
  std::span<const Parameter> (*query)() = nullptr;  ///< its parameters, if it has any
  std::span<const std::string_view> body_keys = {};
  bool reads_body = false;  ///< judges its body itself
};

std::span<const Route> routes();

/// The response to any request: 404 for an unknown path, 405 for a known one with another method, 400 or 422
/// for a query or a body that the route does not take, 500 when the handler throws.
Response respond(Service& service, const Request& request);

}  // namespace capstan
