#include "runner/web/entity_tag.hpp"

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

/// \param list  as `"a", W/"b"`, or `*` for any tag. A tag of this server is hexadecimal, so no other tag
/// contains it.
bool has_tag(const std::string& list, const std::string& tag) {
  return list == "*" || list.find(tag) != list.npos;
}

}  // namespace

Response with_entity_tag(Response response, const httplib::Request& request) {
  const bool is_read = request.method == "GET" || request.method == "HEAD";
  if (!is_read || response.status != 200 || response.next) return response;
  const std::string tag = '"' + sha256_hex(response.body).substr(0, 32) + '"';
  if (has_tag(request.get_header_value("If-None-Match"), tag))
    response = {304, response.content_type, "", response.headers};
  response.headers["ETag"] = tag;
  return response;
}

}  // namespace capstan
