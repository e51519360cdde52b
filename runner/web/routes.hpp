#pragma once
// The table of routes: which function answers which method and path.
#include <httplib.h>

#include <span>
#include <string_view>

#include "runner/web/handlers.hpp"
#include "runner/web/query_parameters.hpp"

namespace capstan {

struct Route {
  std::string_view method;
  std::string_view path;  ///< "{id}" stands for one segment that is not empty
  Handler handler;
  std::span<const QueryParameter> (*query)() = nullptr;  ///< its parameters, if it has any
  std::span<const std::string_view> body_keys = {};
  bool checks_body = false;  ///< the handler checks the body itself
};

std::span<const Route> routes();

/// The response to any request: 404 for an unknown path, 405 for a known one with another method, 400 or 422
/// for a query or a body that the route does not accept, 503 if the database is damaged or unavailable, 500
/// for any other exception.
Response respond(Service& service, const httplib::Request& request);

}  // namespace capstan
