#pragma once
// Conditional requests (RFC 9110, 13.1.2).
#include <httplib.h>

#include "runner/web/response.hpp"

namespace capstan {

/// Adds a strong ETag, a digest of the body, to a response of status 200 to GET or HEAD. Returns 304 without
/// a body if the request's If-None-Match has that tag. Other responses and streams are returned unchanged.
Response with_entity_tag(Response response, const httplib::Request& request);

}  // namespace capstan
