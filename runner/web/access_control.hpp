#pragma once
// Who may send requests: checked by the host name of the request, by the origin of the page that sends it,
// and by a token.
#include <httplib.h>

#include <optional>
#include <string>
#include <vector>

#include "runner/web/response.hpp"

namespace capstan {

struct AccessControl {
  std::vector<std::string> hosts = {};    ///< names of this server besides "localhost" and numeric addresses
  std::optional<std::string> token = {};  ///< required of every request except for the page, if there is one
};

/// 421 for a host that is not this server (DNS rebinding: another site's name that was made to point here),
/// 403 for a page of another origin, 401 for a missing or wrong token; nothing for a request that is allowed.
std::optional<Response> refuse_access(const AccessControl& access, const httplib::Request& request);

}  // namespace capstan
