#include "runner/web/startup_response.hpp"

#include <unistd.h>

#include "solver/case/content_id.hpp"

namespace capstan {

Response health(const std::string& status, const std::filesystem::path& data) {
  return json_response(200, {{"status", status},
                             {"program", "capstan"},
                             {"version", CAPSTAN_VERSION},
                             {"numerics_version", kNumericsVersion},
                             {"data", data.string()},
                             {"pid", getpid()}});
}

Response respond_while_starting(const std::filesystem::path& data, const httplib::Request& request) {
  if (request.path == "/healthz") return health("starting", data);
  Response refusal = problem(503, "Starting",
                             "the server is starting: it checks its database, and brings one of an earlier "
                             "version to the present format; come again in a few seconds");
  refusal.headers["Retry-After"] = "2";
  return refusal;
}

}  // namespace capstan
