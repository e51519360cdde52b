#pragma once
// What the server answers while its database is being checked, or brought to the present format.
#include <filesystem>

#include "runner/web/message.hpp"

namespace capstan {

/// To GET /healthz, so that scripts can tell who holds the port, whose data it serves, and how to end it.
/// \param status  "starting" or "ok"
Response health(const std::string& status, const std::filesystem::path& data);

/// That it is starting; to all else a 503 that says why and when to come again.
Response respond_while_starting(const std::filesystem::path& data, const Request& request);

}  // namespace capstan
