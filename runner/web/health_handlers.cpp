#include <unistd.h>

#include <filesystem>

#include "runner/queries/metrics.hpp"
#include "runner/store/data_directory.hpp"
#include "runner/study/study_schema.hpp"
#include "runner/web/embedded_documents.hpp"
#include "runner/web/handlers.hpp"
#include "runner/web/http_metrics.hpp"
#include "runner/web/openapi_text.hpp"
#include "runner/web/startup_response.hpp"
#include "solver/case/json_schema.hpp"

namespace capstan {

Response get_health(Service& service, const httplib::Request&, const std::string&) {
  return health("ok", service.data().path());
}

/// 503 if a submission could not be stored or computed: if the database is damaged, removed, unreadable or
/// read-only, if the directory of the runs is missing, or if one of their disks is almost full.
Response get_readiness(Service& service, const httplib::Request&, const std::string&) try {
  service.expect_sound_database();
  Database database(service.data().database(),
                    Database::Access::read);  // opened anew: the file may have been removed
  database.query("SELECT 1 FROM schedule").step();
  for (const auto& path : {service.data().path(), service.data().database()})
    if (access(path.c_str(), W_OK) != 0)
      return problem(503, "Not ready", path.string() + " cannot be written");
  if (const std::string reason = service.why_nothing_starts(); !reason.empty())
    return problem(503, "Not ready", reason);
  for (const auto& path : {service.data().path(), service.data().runs()})
    if (const std::string error = WriteProbe(path).error(); !error.empty())
      return problem(503, "Not ready", "nothing can be written in " + path.string() + ": " + error);
  const std::uintmax_t free = std::filesystem::space(service.data().path()).available;
  if (free < kMinFree)
    return problem(
        503, "Not ready",
        "less than " + std::to_string(kMinFree / 1'000'000) + " MB are free in the data directory");
  return json_response(200, {{"status", "ready"}, {"free_bytes", free}});
} catch (const DatabaseDamaged& error) {
  service.report_damage(error.what());
  return problem(503, "Not ready", error.what());
} catch (const std::exception& error) {
  return problem(503, "Not ready", error.what());
}

Response get_metrics(Service& service, const httplib::Request&, const std::string&) {
  const Readers::Reader database = service.reader();
  return {200,
          "text/plain; version=0.0.4; charset=utf-8",
          metrics_text(*database, service.executor().slots()) + service.executor().metrics() +
              http_metrics().text(),
          {}};
}

Response get_openapi(Service&, const httplib::Request&, const std::string&) {
  return {200, "application/yaml", openapi_text(), {}};
}

Response get_study_schema(Service&, const httplib::Request&, const std::string&) {
  return {200, "application/schema+json", study_schema().dump(2) + "\n", {}};
}

Response get_case_schema(Service&, const httplib::Request&, const std::string&) {
  return {200, "application/schema+json", case_schema().dump(2) + "\n", {}};
}

}  // namespace capstan
