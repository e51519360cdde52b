#pragma once
// What the server answers before its service is ready: while the database is checked, or migrated to the
// present schema.
#include <httplib.h>

#include <filesystem>

#include "runner/web/response.hpp"

namespace capstan {

/// The response to GET /healthz: which program owns the port, with its data directory and process id.
/// \param status  "starting" or "ok"
Response health(const std::string& status, const std::filesystem::path& data);

/// health("starting") to GET /healthz; 503 with the reason and Retry-After to all other requests.
Response respond_while_starting(const std::filesystem::path& data, const httplib::Request& request);

}  // namespace capstan
