#include <unistd.h>

#include "runner/web/api.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {

/// Says that this is Capstan, so that scripts can tell who holds the port, whose data it serves, and how to end it.
Response get_health(Service& service, const Request&, const std::string&) {
  return json_response(200, {{"status", "ok"},
                             {"program", "capstan"},
                             {"version", CAPSTAN_VERSION},
                             {"numerics_version", kNumericsVersion},
                             {"data", service.data().path().string()},
                             {"pid", getpid()}});
}

}  // namespace capstan
