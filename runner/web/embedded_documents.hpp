#pragma once
// Files of schema/ that the server returns, embedded by the build.

namespace capstan {

extern const char* const kOpenApi;  ///< openapi.yaml

}  // namespace capstan
