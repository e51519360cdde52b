#pragma once

namespace capstan {

/// The text of schema/openapi.yaml.
extern const char* const kOpenApi;

}  // namespace capstan
