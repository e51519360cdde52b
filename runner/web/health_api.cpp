#include <unistd.h>

#include "runner/web/api.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {

/// Says that this is Capstan, so that scripts can tell who holds the port, and how to end it.
Response get_health(Service&, const Request&, const std::string&) {
  return json_response(200, {{"status", "ok"},
                             {"program", "capstan"},
                             {"version", CAPSTAN_VERSION},
                             {"numerics_version", kNumericsVersion},
                             {"pid", getpid()}});
}

}  // namespace capstan
