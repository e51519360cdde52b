#pragma once
// Which function answers which method and path.
#include <span>
#include <string>
#include <string_view>

#include "runner/web/api.hpp"

namespace capstan {

struct Route {
  std::string_view method;
  std::string_view path;  ///< "{id}" stands for one segment
  Handler handler;
};

std::span<const Route> routes();

/// The response to any request: 404 for an unknown path, 405 for a known one with another method, 500 when
/// the handler throws.
Response respond(Service& service, const Request& request);

}  // namespace capstan
