#pragma once
#include <string>

namespace capstan {

/// schema/openapi.yaml as it is served: with one property of a history for each observable that the database
/// keeps, with its unit and description.
const std::string& openapi_text();

}  // namespace capstan
