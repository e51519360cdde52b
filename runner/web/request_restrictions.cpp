#include "runner/web/request_restrictions.hpp"

#include "runner/web/ascii_case.hpp"
#include "runner/web/request_head.hpp"

namespace capstan {
namespace {

/// Ignores the parameters of the type, such as charset.
bool has_media_type(const httplib::Request& request, std::string_view wanted) {
  const std::string field = request.get_header_value("Content-Type");
  const std::string type = field.substr(0, field.find(';'));
  return equal_ignoring_case(type.substr(0, type.find_last_not_of(" \t") + 1), wanted);
}

}  // namespace

std::optional<Response> refuse_unsupported(const httplib::Request& request) {
  const std::size_t length = content_length(request);
  if (request.has_header("Transfer-Encoding"))
    return problem(411, "Length required", "send the body with a Content-Length, not in chunks");
  if (length > kMaxBody) return problem(413, "Content too large", "a body has at most 1 MiB");
  if (request.has_header("Content-Encoding"))
    return problem(415, "Unsupported media type", "send the body uncompressed");
  if (length > 0 && !has_media_type(request, "application/json"))
    return problem(415, "Unsupported media type", "send JSON, as Content-Type: application/json");
  if (request.has_header("Range")) return problem(416, "Range not satisfiable", "answers come as a whole");
  if (request.has_header("Expect") &&
      !equal_ignoring_case(request.get_header_value("Expect"), "100-continue"))
    return problem(417, "Expectation failed", "nothing but 100-continue can be expected");
  return std::nullopt;
}

}  // namespace capstan
